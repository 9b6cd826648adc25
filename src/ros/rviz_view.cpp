#include "ratchet_sieve/ros/rviz_view.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/ros/scene_markers.h"

namespace ratchet_sieve
{
namespace
{
/// Width of the visible part of a level machine, in widths of the base: with a bin at each end, and without.
constexpr double OPEN_WIDTH = 1.36;
constexpr double CLOSED_WIDTH = 1.25;

/// Middle between the captions above and the bins or the legend below [widths of the base].
constexpr double OPEN_MIDDLE = 0.05;
constexpr double CLOSED_MIDDLE = 0.06;

constexpr int TEETH_SHOWN = 10;
constexpr double TEETH_WIDTH = 1.05;   // of the picture, in widths of the teeth
constexpr double TEETH_MIDDLE = 0.35;  // their height above its lower edge, in its heights

/// Names of the saved views in sieve.rviz.
constexpr const char* MACHINE_VIEW = "Whole machine";
constexpr const char* MIDDLE_VIEW = "Ten teeth in the middle";
constexpr const char* LEFT_VIEW = "Ten teeth at the left end";

/// Width over height of the part of the window that shows the scene: 1248 by 640 of 1280 by 800 pixels.
constexpr double ASPECT = 1.95;

/// Visible height over the distance of the camera. @param field_of_view vertical [rad]
double heightPerDistance(double field_of_view)
{
  return 2.0 * std::tan(0.5 * field_of_view);
}

/// A part of the machine's plane.
struct Frame
{
  double x;      ///< middle [m]
  double y;      ///< middle, upwards [m]
  double width;  ///< [m]
};

Frame wholeMachine(const SceneDefinition& scene)
{
  const double width = scene.base.width();
  const bool open = scene.boundary == Boundary::OPEN;
  const double rise = captionHeight(scene, scene.base.inclination) - LEAST_CAPTION_HEIGHT;
  return {0.5 * width, width * ((open ? OPEN_MIDDLE : CLOSED_MIDDLE) + 0.5 * rise),
          width * ((open ? OPEN_WIDTH : CLOSED_WIDTH) + ASPECT * rise)};
}

/// @param along_base middle of the teeth, from the base's left end [m]
Frame teethAround(double along_base, const SceneDefinition& scene)
{
  const double width = TEETH_WIDTH * std::min(TEETH_SHOWN, scene.base.teeth) * scene.base.toothWidth();
  const double inclination = scene.base.inclination;
  return {along_base * std::cos(inclination),
          along_base * std::sin(inclination) + (0.5 - TEETH_MIDDLE) * width / ASPECT, width};
}

Frame middleTeeth(const SceneDefinition& scene)
{
  return teethAround(0.5 * scene.base.width(), scene);
}

Frame leftTeeth(const SceneDefinition& scene)
{
  return teethAround(0.5 * std::min(TEETH_SHOWN, scene.base.teeth) * scene.base.toothWidth(), scene);
}

/// @param view an orbit view, looking along y
void show(const Frame& frame, YAML::Node view)
{
  const double field_of_view = view["Field of View"].as<double>();
  view["Distance"] = frame.width / (ASPECT * heightPerDistance(field_of_view));
  view["Focal Point"]["X"] = frame.x;
  view["Focal Point"]["Y"] = 0.0;
  view["Focal Point"]["Z"] = frame.y;
}
}  // namespace

std::string fittedToScene(const std::string& config, const SceneDefinition& scene, RvizView view)
{
  try
  {
    YAML::Node root = YAML::Load(config);
    YAML::Node views = root["Visualization Manager"]["Views"];
    show(view == RvizView::TEETH ? middleTeeth(scene) : wholeMachine(scene), views["Current"]);
    for (YAML::Node saved : views["Saved"])
    {
      const auto name = saved["Name"].as<std::string>();
      if (name == MIDDLE_VIEW || name == LEFT_VIEW)
        show(name == LEFT_VIEW ? leftTeeth(scene) : middleTeeth(scene), saved);
      else if (name == MACHINE_VIEW)
        show(wholeMachine(scene), saved);
    }
    return YAML::Dump(root) + "\n";
  }
  catch (const YAML::Exception& error)
  {
    throw std::invalid_argument(std::string("no configuration of RViz: ") + error.what());
  }
}

}  // namespace ratchet_sieve
