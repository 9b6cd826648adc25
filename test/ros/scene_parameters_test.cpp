#include "scene_parameters.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "errors.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
using XmlRpc::XmlRpcValue;

/// A scene file as loaded by roslaunch: YAML as stored on the parameter server.
XmlRpcValue asParameter(const YAML::Node& node)
{
  XmlRpcValue value;
  if (node.IsSequence())
  {
    value.setSize(static_cast<int>(node.size()));
    for (std::size_t k = 0; k < node.size(); ++k)
      value[static_cast<int>(k)] = asParameter(node[k]);
    return value;
  }
  if (node.IsMap())
  {
    value.begin();  // turns it into a struct, even an empty one
    for (const auto& item : node)
      value[item.first.as<std::string>()] = asParameter(item.second);
    return value;
  }
  int integer = 0;
  double number = 0.0;
  bool flag = false;
  if (YAML::convert<int>::decode(node, integer))
    return XmlRpcValue(integer);
  if (YAML::convert<double>::decode(node, number))
    return XmlRpcValue(number);
  if (YAML::convert<bool>::decode(node, flag))
    return XmlRpcValue(flag);
  return XmlRpcValue(node.as<std::string>());
}

TEST(SceneParameters, giveTheSceneOfTheFile)
{
  const std::string canonical = canonicalYaml(smallMixture());
  const YAML::Node root = yamlFromParameter(asParameter(YAML::Load(canonical)), "parameter /sieve/scene");
  EXPECT_EQ(canonicalYaml(sceneFromYaml(root, "parameter /sieve/scene").definition), canonical);
}

TEST(SceneParameters, keepEveryBitOfANumber)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const auto number = *rc::gen::arbitrary<double>();
        RC_ASSERT(yamlFromParameter(XmlRpcValue(number), "x").as<double>() == number);
      }));
}

TEST(SceneParameters, areNamedInErrors)
{
  const std::string name = "parameter /sieve/scene";
  XmlRpcValue scene = asParameter(YAML::Load(canonicalYaml(smallMixture())));
  scene["base"]["asymmetry"] = 2.0;
  const std::string error = errorOf([&] { sceneFromYaml(yamlFromParameter(scene, name), name); });
  EXPECT_TRUE(begins(error, name) && error.find("base.asymmetry") != std::string::npos) << error;
  std::string bytes = "abc";
  scene["base"]["teeth"] = XmlRpcValue(bytes.data(), 3);
  EXPECT_EQ(errorOf([&] { yamlFromParameter(scene, name); }),
            name + "/base/teeth: a date, binary or nothing: allowed are numbers, text, lists and maps");
}
}  // namespace
}  // namespace ratchet_sieve
