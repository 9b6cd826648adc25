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

/// The scene in the parameter `scene` of a node handle, as YAML, and its source.
struct SceneParameter
{
  YAML::Node root;
  std::string source;  ///< for example "parameter /sieve/scene"
};

/// @throws SceneError if there is no scene or a bad one. The message gives the line of the file if the
/// parameter `scene_file` names the file from which the scene was loaded
SceneParameter readSceneParameter(const ros::NodeHandle& node);

}  // namespace ratchet_sieve
