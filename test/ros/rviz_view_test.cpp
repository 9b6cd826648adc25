#include <cmath>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/ros/rviz_view.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
std::string ownConfig()
{
  return contents(RATCHET_SIEVE_RVIZ_CONFIG);
}

YAML::Node viewOf(const std::string& config)
{
  return YAML::Load(config)["Visualization Manager"]["Views"]["Current"];
}

TEST(RvizView, showsAllOfTheMachine)
{
  for (const int teeth : {4, 40, 400})
    for (const Boundary boundary : {Boundary::OPEN, Boundary::PERIODIC})
    {
      SceneDefinition scene = smallMixture();
      scene.base.teeth = teeth;
      scene.boundary = boundary;
      const YAML::Node view = viewOf(fittedToScene(ownConfig(), scene));
      const double width = scene.base.width();
      EXPECT_DOUBLE_EQ(view["Focal Point"]["X"].as<double>(), 0.5 * width);
      // Seen in a window of 1248 by 640: the base, and the bins of an open one, but not much else.
      const double height =
          2.0 * view["Distance"].as<double>() * std::tan(0.5 * view["Field of View"].as<double>());
      const double seen = height * 1248.0 / 640.0;
      const double needed = boundary == Boundary::OPEN ? 1.32 * width : width;
      EXPECT_GT(seen, needed);
      EXPECT_LT(seen, 1.3 * needed);
    }
}

TEST(RvizView, leavesTheRestAsItIs)
{
  YAML::Node before = YAML::Load(ownConfig());
  YAML::Node after = YAML::Load(fittedToScene(ownConfig(), smallMixture()));
  for (YAML::Node* root : {&before, &after})
  {
    (*root)["Visualization Manager"]["Views"]["Current"].remove("Distance");
    (*root)["Visualization Manager"]["Views"]["Current"].remove("Focal Point");
  }
  EXPECT_EQ(YAML::Dump(after), YAML::Dump(before));
}

TEST(RvizView, refusesWhatIsNoConfiguration)
{
  for (const char* text : {"", "no: view", "{", "Visualization Manager: 3"})
    EXPECT_THROW(fittedToScene(text, smallMixture()), std::invalid_argument) << text;
}
}  // namespace
}  // namespace ratchet_sieve
