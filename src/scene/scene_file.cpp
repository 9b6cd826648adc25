#include "ratchet_sieve/scene/scene_file.h"

#include <fstream>

#include "depth_limiter.h"
#include "ratchet_sieve/scene/input_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

/// A scene that places a hundred thousand disks one by one has some ten megabytes. yaml-cpp takes up to
/// 250 times as much memory for its tokens and nodes.
constexpr std::size_t LARGEST_TEXT = 16u << 20;  ///< [bytes]

/// The file's text, or so much of it that it is seen to be too large.
std::string readText(const std::string& path)
{
  if (const auto why = whyUnreadable(path))
    throw SceneError(path + ": " + *why);
  std::ifstream file(path, std::ios::binary);
  std::string text;
  char part[4096];
  while (text.size() <= LARGEST_TEXT && (file.read(part, sizeof part), file.gcount() > 0))
    text.append(part, static_cast<std::size_t>(file.gcount()));
  return text;
}

YAML::Node parseText(const std::string& text, const std::string& source)
{
  if (text.size() > LARGEST_TEXT)
    throw SceneError(source + ": too large; a scene has at most " + std::to_string(LARGEST_TEXT) + " bytes");
  try
  {
    requireShallow(text, Aliases::ALLOWED);
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error)
  {
    throw SceneError(source + ":" + std::to_string(error.mark.line + 1) +
                     ": not YAML: " + shownText(error.msg));
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
