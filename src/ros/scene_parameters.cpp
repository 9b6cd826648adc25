#include "scene_parameters.h"

#include <fmt/format.h>
#include <ros/console.h>

#include "node_parameters.h"
#include "ratchet_sieve/scene/entry.h"

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

/// Sets the keys of a tree in the scene; lists replace lists. @return the keys, for the log
std::string putOnTop(YAML::Node& scene, const YAML::Node& tree, const std::string& prefix = "")
{
  std::string keys;
  for (const auto& item : tree)
  {
    const std::string key = prefix + item.first.Scalar();
    std::string put = key;
    if (item.second.IsMap())
      put = putOnTop(scene, item.second, key + '.');
    else
      applyOverride(scene, key, item.second);
    keys += (keys.empty() || put.empty() ? "" : ", ") + put;
  }
  return keys;
}

YAML::Node requireMap(const YAML::Node& tree, const std::string& source, const std::string& name)
{
  Entry(tree, source, name).keys();
  return tree;
}

/// ~set and ~seed.
void applySettings(const ros::NodeHandle& node, ParameterReader& reader, YAML::Node& scene)
{
  const std::string source = "parameter " + reader.fullName("set");
  if (const std::string text = reader.text("set", ""); !text.empty())
    for (const auto& item : requireMap(copyableYaml(text, source), source, "set"))
      applyOverride(scene, item.first.Scalar(), item.second);
  XmlRpc::XmlRpcValue seed;
  if (node.getParam("seed", seed))
    if (const YAML::Node value = yamlFromParameter(seed, node.resolveName("seed")); value.Scalar() != "")
      applyOverride(scene, "seed", value);
}
}  // namespace

YAML::Node yamlFromParameter(const XmlRpc::XmlRpcValue& value, const std::string& source)
{
  YAML::Node node;
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
      node = YAML::Node(YAML::NodeType::Sequence);
      for (int k = 0; k < value.size(); ++k)
        node.push_back(yamlFromParameter(value[k], source + "/" + std::to_string(k)));
      return node;
    case XmlRpc::XmlRpcValue::TypeStruct:
      node = YAML::Node(YAML::NodeType::Map);
      for (const auto& [key, entry] : value)
        node[key] = yamlFromParameter(entry, fmt::format("{}/{}", source, key));
      return node;
    default:
      throw SceneError(source + ": a date, binary or nothing: allowed are numbers, text, lists and maps");
  }
}

SceneParameter readSceneParameter(const ros::NodeHandle& node)
{
  ParameterReader reader(node);
  const std::string file = reader.text("scene_file", "");
  const std::string tree_source = "parameter " + reader.fullName("scene");
  XmlRpc::XmlRpcValue value;
  const bool has_tree = node.getParam("scene", value);
  if (file.empty() && !has_tree)
    throw SceneError("parameter " + reader.fullName("scene_file") +
                     ": not set: must be the path of a scene file");
  const YAML::Node tree =
      has_tree ? requireMap(yamlFromParameter(value, tree_source), tree_source, "scene") : YAML::Node();
  SceneParameter scene = file.empty() ? SceneParameter{tree, tree_source}
                                      : SceneParameter{copyableYaml(readYamlText(file), file), file};
  if (const std::string keys = file.empty() ? "" : putOnTop(scene.root, tree); !keys.empty())
    ROS_INFO("%s, but %s of %s", file.c_str(), keys.c_str(), tree_source.c_str());
  applySettings(node, reader, scene.root);
  scene.feed_file = sceneFromYaml(scene.root, scene.source).feed_file;
  return scene;
}

}  // namespace ratchet_sieve
