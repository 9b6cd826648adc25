#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// Longest duration of a scene, and of durations that are ROS parameters [s].
constexpr double LONGEST_DURATION = 1e9;

/// An invalid scene: one line with file, line (if there is one), key, value and what is allowed.
struct SceneError : std::runtime_error
{
  explicit SceneError(const std::string& line, std::string at_key = "", std::string given = "",
                      std::string reason = "")
      : std::runtime_error(line), key(std::move(at_key)), value(std::move(given)), allowed(std::move(reason))
  {
  }

  std::string key;      ///< dotted path; these are empty if the line is about no key
  std::string value;    ///< as given
  std::string allowed;  ///< or what is wrong
};

/// A validated scene and its warnings.
struct Scene
{
  SceneDefinition definition;         ///< resolved: every count is set, a density is split up
  std::vector<std::string> warnings;  ///< ignored keys, and implausibilities()
  std::string feed_file;              ///< its path, where feed.file was read
};

/// Reads a scene from a file.
/// @param overrides `KEY=VALUE`, KEY a dotted path (base.inclination=0.105, species.0.radius=0.004)
/// @throws SceneError
Scene loadSceneFile(const std::string& path, const std::vector<std::string>& overrides = {});

/// Reads a scene from a YAML tree. Files, the parameter server and bags are all read through this function.
/// @param source named in errors: a path, or "parameter /sieve/scene"
/// @throws SceneError
Scene sceneFromYaml(const YAML::Node& root, const std::string& source);

/// Reads a scene from YAML text, as a recorded SceneFrame carries it. @param overrides as of loadSceneFile()
/// @throws SceneError
Scene sceneFromText(const std::string& text, const std::string& source,
                    const std::vector<std::string>& overrides = {});

/// Implausible values of a valid scene, such as lengths in mm instead of m: a line for each, with the key,
/// its value, the reason and, if there is one, a suggested value. Empty for a scene that could be built.
///
/// Where possible, limits are ratios within the scene, so that they hold for machines of any size.
/// @param scene as it was read: every count is set
std::vector<std::string> implausibilities(const SceneDefinition& scene);

/// The path of a file that a scene names: relative to the scene's file; for a scene that is in no file, to
/// the working directory. @param source of the scene
std::string pathFromScene(const std::string& source, const std::string& path);

/// Why a file cannot be opened for reading: "no such file", "is a directory" or the system's message; nothing
/// if it can.
std::optional<std::string> whyUnreadable(const std::string& path);

/// The text of a YAML file. A file larger than any scene is cut at a length that copyableYaml() refuses.
/// @throws SceneError
std::string readYamlText(const std::string& path);

/// The tree of a YAML text, with limited size and depth and without aliases, so that copying it terminates.
/// @param source named in errors @throws SceneError
YAML::Node copyableYaml(const std::string& text, const std::string& source);

/// A copy of a tree, without line numbers: those of YAML::Clone() are wrong. @pre no part contains itself
YAML::Node copyWithoutLines(const YAML::Node& node);

/// The keys of `accuracy` that decide when a run ends.
std::vector<std::string> certaintyKeyNames();

/// Sets KEY=VALUE in a YAML tree; KEY=null takes the key out of it. base.profile takes out the keys of the
/// sawtooth, base.length that of the teeth. @throws SceneError
void applyOverride(YAML::Node& root, const std::string& assignment);

/// As KEY=VALUE, the value given as a tree.
void applyOverride(YAML::Node& root, const std::string& key, const YAML::Node& value);

}  // namespace ratchet_sieve
