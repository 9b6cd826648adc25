#include <cmath>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/ros/rviz_view.h"
#include "ratchet_sieve/ros/scene_markers.h"
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

TEST(RvizView, showsTheCaptionOverASteepBase)
{
  SceneDefinition scene = smallMixture();
  const auto roomAbove = [&scene](double inclination)
  {
    scene.base.inclination = inclination;
    const YAML::Node view = viewOf(fittedToScene(ownConfig(), scene, RvizView::MACHINE));
    const double height =
        2.0 * view["Distance"].as<double>() * std::tan(0.5 * view["Field of View"].as<double>());
    return view["Focal Point"]["Z"].as<double>() + 0.5 * height -
           captionHeight(scene, inclination) * scene.base.width();
  };
  for (const double inclination : {-0.4, 0.2, 0.35, 0.7})
    EXPECT_NEAR(roomAbove(inclination), roomAbove(0.0), 1e-9) << inclination;
}

TEST(RvizView, showsAllOfTheMachine)
{
  for (const int teeth : {4, 40, 400})
    for (const Boundary boundary : {Boundary::OPEN, Boundary::PERIODIC})
    {
      SceneDefinition scene = smallMixture();
      scene.base.teeth = teeth;
      scene.boundary = boundary;
      const YAML::Node view = viewOf(fittedToScene(ownConfig(), scene, RvizView::MACHINE));
      const double width = scene.base.width();
      EXPECT_DOUBLE_EQ(view["Focal Point"]["X"].as<double>(), 0.5 * width);
      // In a window of 1248 by 640: the base, and the bins of an open one, fill most of the view, but for
      // what a high caption takes.
      const double height =
          2.0 * view["Distance"].as<double>() * std::tan(0.5 * view["Field of View"].as<double>());
      const double seen = height * 1248.0 / 640.0;
      const double needed = boundary == Boundary::OPEN ? 1.32 * width : width;
      EXPECT_GT(seen, needed);
      EXPECT_LT(seen, 1.3 * needed + 2.0 * (captionHeight(scene, 0.0) - LEAST_CAPTION_HEIGHT) * width);
    }
}

/// The visible part of the plane: x and z of its lower left corner and its size, in a window of 1248 by 640.
struct Seen
{
  double x, z, width, height;
};

Seen seenBy(const YAML::Node& view)
{
  const double height =
      2.0 * view["Distance"].as<double>() * std::tan(0.5 * view["Field of View"].as<double>());
  const double width = height * 1248.0 / 640.0;
  return {view["Focal Point"]["X"].as<double>() - 0.5 * width,
          view["Focal Point"]["Z"].as<double>() - 0.5 * height, width, height};
}

TEST(RvizView, showsTenTeethOfALongBaseLargeEnoughToSeeDisks)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 382;
  scene.base.inclination = 0.1;
  const Seen seen = seenBy(viewOf(fittedToScene(ownConfig(), scene, RvizView::TEETH)));
  EXPECT_NEAR(seen.width, 10.5 * scene.base.tooth_width, 0.01 * scene.base.tooth_width);
  // The middle of the base is visible, with space for disks above and teeth below.
  const double x = 0.5 * scene.base.width() * std::cos(0.1);
  const double z = 0.5 * scene.base.width() * std::sin(0.1);
  EXPECT_NEAR(x, seen.x + 0.5 * seen.width, 1e-9);
  EXPECT_GT(z, seen.z + 2.0 * scene.base.tooth_height);
  EXPECT_LT(z, seen.z + 0.5 * seen.height);
  // Diameter of the smallest disk in pixels.
  EXPECT_GT(2.0 * scene.species[0].radius * 640.0 / seen.height, 10.0);
}

TEST(RvizView, fitsTheSavedViewsToTheScene)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 382;
  const std::string config = fittedToScene(ownConfig(), scene, RvizView::MACHINE);
  const YAML::Node saved = YAML::Load(config)["Visualization Manager"]["Views"]["Saved"];
  ASSERT_EQ(saved.size(), 3u);
  EXPECT_EQ(saved[0]["Distance"].as<double>(), viewOf(config)["Distance"].as<double>());
  const YAML::Node teeth = viewOf(fittedToScene(ownConfig(), scene, RvizView::TEETH));
  EXPECT_EQ(YAML::Dump(saved[1]["Focal Point"]), YAML::Dump(teeth["Focal Point"]));
  EXPECT_NEAR(seenBy(saved[2]).x + 0.5 * seenBy(saved[2]).width, 5.0 * scene.base.tooth_width, 1e-9);
}

TEST(RvizView, showsAllTeethOfAShortBase)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 4;
  const Seen seen = seenBy(viewOf(fittedToScene(ownConfig(), scene, RvizView::TEETH)));
  EXPECT_NEAR(seen.width, 1.05 * scene.base.width(), 0.01 * scene.base.width());
}

TEST(RvizView, leavesTheRestAsItIs)
{
  YAML::Node before = YAML::Load(ownConfig());
  YAML::Node after = YAML::Load(fittedToScene(ownConfig(), smallMixture(), RvizView::MACHINE));
  for (YAML::Node* root : {&before, &after})
  {
    YAML::Node views = (*root)["Visualization Manager"]["Views"];
    for (YAML::Node view : {views["Current"], views["Saved"][0], views["Saved"][1], views["Saved"][2]})
    {
      view.remove("Distance");
      view.remove("Focal Point");
    }
  }
  EXPECT_EQ(YAML::Dump(after), YAML::Dump(before));
}

TEST(RvizView, refusesWhatIsNoConfiguration)
{
  for (const char* text : {"", "no: view", "{", "Visualization Manager: 3"})
    EXPECT_THROW(fittedToScene(text, smallMixture(), RvizView::MACHINE), std::invalid_argument) << text;
}
}  // namespace
}  // namespace ratchet_sieve
