#include "ratchet_sieve/ros/scene_parameters.h"

#include <fmt/format.h>

#include "ratchet_sieve/scene/input_file.h"

namespace ratchet_sieve
{
namespace
{
// XmlRpcValue converts its content only through non-const references: hence the copies of small values.
template <typename T>
YAML::Node scalar(XmlRpc::XmlRpcValue value)
{
  return YAML::Node(static_cast<T&>(value));
}

YAML::Node sequence(const XmlRpc::XmlRpcValue& value, const std::string& source)
{
  YAML::Node node(YAML::NodeType::Sequence);
  for (int k = 0; k < value.size(); ++k)
    node.push_back(yamlFromParameter(value[k], source + "/" + std::to_string(k)));
  return node;
}

YAML::Node map(const XmlRpc::XmlRpcValue& value, const std::string& source)
{
  YAML::Node node(YAML::NodeType::Map);
  for (const auto& [key, entry] : value)
    node[key] = yamlFromParameter(entry, fmt::format("{}/{}", source, key));
  return node;
}
}  // namespace

YAML::Node yamlFromParameter(const XmlRpc::XmlRpcValue& value, const std::string& source)
{
  switch (value.getType())
  {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return scalar<bool>(value);
    case XmlRpc::XmlRpcValue::TypeInt:
      return scalar<int>(value);
    case XmlRpc::XmlRpcValue::TypeDouble:
      return scalar<double>(value);
    case XmlRpc::XmlRpcValue::TypeString:
      return scalar<std::string>(value);
    case XmlRpc::XmlRpcValue::TypeArray:
      return sequence(value, source);
    case XmlRpc::XmlRpcValue::TypeStruct:
      return map(value, source);
    default:
      throw SceneError(source + ": a date, binary or nothing: allowed are numbers, text, lists and maps");
  }
}

namespace
{
/// Reads the file from which the scene was loaded, because the parameter server knows no line numbers for an
/// error message.
/// @throws SceneError if the file is bad as well
void requireGoodFile(const ros::NodeHandle& node)
{
  const std::string file = node.param<std::string>("scene_file", "");
  if (!file.empty() && !whyUnreadable(file))
    loadSceneFile(file);
}
}  // namespace

SceneParameter readSceneParameter(const ros::NodeHandle& node)
{
  const std::string source = "parameter " + node.resolveName("scene");
  XmlRpc::XmlRpcValue value;
  if (!node.getParam("scene", value))
    throw SceneError(source + ": not set: load a scene file there, as launch/sieve.launch does");
  SceneParameter parameter{yamlFromParameter(value, source), source};
  try
  {
    sceneFromYaml(parameter.root, source);
  }
  catch (const SceneError&)
  {
    requireGoodFile(node);
    throw;
  }
  return parameter;
}

}  // namespace ratchet_sieve
