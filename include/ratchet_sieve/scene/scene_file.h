#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// A scene that cannot be: one line that names file, line (where there is one), key, value and
/// what is allowed.
struct SceneError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A validated scene and what its author should know about it.
struct Scene
{
  SceneDefinition definition;         ///< resolved: every count is set, a density is split up
  std::vector<std::string> warnings;  ///< keys that are given in vain, and implausibilities()
};

/// Reads a scene from a file.
/// @param overrides `KEY=VALUE`, KEY a dotted path (base.inclination=0.105, species.0.radius=0.004)
/// @throws SceneError
Scene loadSceneFile(const std::string& path, const std::vector<std::string>& overrides = {});

/// Reads a scene from a YAML tree, wherever it came from: the one way in for files, the parameter
/// server and bags.
/// @param source named in errors: a path, or "parameter /sieve/scene"
/// @throws SceneError
Scene sceneFromYaml(const YAML::Node& root, const std::string& source);

/// Reads a scene from YAML text, as a recorded SceneFrame carries it. @throws SceneError
Scene sceneFromText(const std::string& text, const std::string& source);

/// The text of a file that holds YAML; of one larger than any scene only so much that copyableYaml() refuses
/// it. @throws SceneError
std::string readYamlText(const std::string& path);

/// The tree of a YAML text, of limited size and depth and without aliases, so that YAML::Clone() comes to an
/// end. @param source named in errors @throws SceneError
YAML::Node copyableYaml(const std::string& text, const std::string& source);

/// The keys of `accuracy` that decide when a run ends.
std::vector<std::string> certaintyKeyNames();

/// Sets KEY=VALUE in a YAML tree. @throws SceneError
void applyOverride(YAML::Node& root, const std::string& assignment);

}  // namespace ratchet_sieve
