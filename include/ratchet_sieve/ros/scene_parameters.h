#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// A tree of the parameter server as YAML. Doubles keep every bit. Text stays plain, as in a file:
/// what rosparam takes for text and YAML 1.2 for a number, such as 1e-3, is a number here.
/// @throws SceneError for dates and binaries, which no scene has
/// @param source names the parameter in errors
YAML::Node yamlFromParameter(const XmlRpc::XmlRpcValue& value, const std::string& source);

/// The scene under `scene` of the node handle, as YAML, and where it comes from.
struct SceneParameter
{
  YAML::Node root;
  std::string source;  ///< such as "parameter /sieve/scene"
};

/// @throws SceneError where there is none, or a bad one; it names the line of `scene_file`, where that
/// parameter names the file that the scene was loaded from
SceneParameter readSceneParameter(const ros::NodeHandle& node);

}  // namespace ratchet_sieve
