#include "ratchet_sieve/scene/scene_file.h"

#include <fstream>

#include "depth_limiter.h"
#include "ratchet_sieve/scene/input_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

/// A scene that places a hundred thousand disks one by one has about ten megabytes. yaml-cpp needs up to 250
/// times as much memory for its tokens and nodes.
constexpr std::size_t LARGEST_TEXT = 16u << 20;  ///< [bytes]

}  // namespace

std::string readYamlText(const std::string& path)
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

YAML::Node copyableYaml(const std::string& text, const std::string& source)
{
  if (text.size() > LARGEST_TEXT)
    throw SceneError(source + ": too large; must have at most " + std::to_string(LARGEST_TEXT) + " bytes");
  try
  {
    requireShallow(text);
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error)
  {
    throw SceneError(source + ":" + std::to_string(error.mark.line + 1) +
                     ": not YAML: " + shownText(error.msg));
  }
}

Scene sceneFromText(const std::string& text, const std::string& source,
                    const std::vector<std::string>& overrides)
{
  YAML::Node root = copyableYaml(text, source);
  for (const std::string& assignment : overrides)
    applyOverride(root, assignment);
  return sceneFromYaml(root, source);
}

Scene loadSceneFile(const std::string& path, const std::vector<std::string>& overrides)
{
  return sceneFromText(readYamlText(path), path, overrides);
}

}  // namespace ratchet_sieve
