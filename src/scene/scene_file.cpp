#include "ratchet_sieve/scene/scene_file.h"

#include <fstream>
#include <sstream>

#include "depth_limiter.h"

namespace ratchet_sieve
{
namespace
{

/// A scene that places a hundred thousand disks one by one has some ten megabytes.
constexpr std::size_t LARGEST_TEXT = 64u << 20;  ///< [bytes]

std::string readText(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()))
    throw SceneError(path + ": cannot be read as a scene file");
  return text.str();
}

YAML::Node parseText(const std::string& text, const std::string& source)
{
  if (text.size() > LARGEST_TEXT)
    throw SceneError(source + ": has " + std::to_string(text.size()) + " bytes; a scene has at most " +
                     std::to_string(LARGEST_TEXT));
  try
  {
    requireShallow(text);
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error)
  {
    throw SceneError(source + ":" + std::to_string(error.mark.line + 1) + ": not YAML: " + error.msg);
  }
}

}  // namespace

Scene sceneFromText(const std::string& text, const std::string& source)
{
  return sceneFromYaml(parseText(text, source), source);
}

Scene loadSceneFile(const std::string& path, const std::vector<std::string>& overrides)
{
  YAML::Node root = parseText(readText(path), path);
  for (const std::string& assignment : overrides)
    applyOverride(root, assignment);
  return sceneFromYaml(root, path);
}

}  // namespace ratchet_sieve
