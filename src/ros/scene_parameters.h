#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// Converts a value of the parameter server to YAML. Doubles keep every bit. Strings stay plain scalars, as
/// in a file: values like 1e-3, which are strings for rosparam but numbers in YAML 1.2, are numbers here.
/// @throws SceneError for dates and binaries, which no scene contains
/// @param source name of the parameter in error messages
YAML::Node yamlFromParameter(const XmlRpc::XmlRpcValue& value, const std::string& source);

/// The scene of a node, as YAML, and its source.
struct SceneParameter
{
  YAML::Node root;
  std::string source;          ///< a path, or for example "parameter /sieve/scene"
  std::string feed_file = {};  ///< its path, where feed.file was read
};

/// The scene of the file that the parameter `scene_file` names, or of the tree `scene`. Where both are given,
/// the tree's keys are set in the file's scene; then those of `set` (YAML text, such as
/// "{base.inclination: 0.1}") and `seed`.
/// @throws SceneError if there is no scene or a bad one @throws ParameterError
SceneParameter readSceneParameter(const ros::NodeHandle& node);

}  // namespace ratchet_sieve
