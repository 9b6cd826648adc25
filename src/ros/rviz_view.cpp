#include "ratchet_sieve/ros/rviz_view.h"

#include <cmath>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

namespace ratchet_sieve
{
namespace
{
/// What there is to see, in widths of the base: with a bin at each end, and without.
constexpr double OPEN_WIDTH = 1.36;
constexpr double CLOSED_WIDTH = 1.25;

/// The middle of the captions above and the bins or the legend below [widths of the base].
constexpr double OPEN_MIDDLE = 0.05;
constexpr double CLOSED_MIDDLE = 0.06;

/// Width over height of the part of the window that shows the scene: 1248 by 640 of 1280 by 800 pixels.
constexpr double ASPECT = 1.95;

/// Height of what a camera sees over its distance. @param field_of_view in the vertical [rad]
double heightPerDistance(double field_of_view)
{
  return 2.0 * std::tan(0.5 * field_of_view);
}
}  // namespace

std::string fittedToScene(const std::string& config, const SceneDefinition& scene)
{
  try
  {
    YAML::Node root = YAML::Load(config);
    YAML::Node view = root["Visualization Manager"]["Views"]["Current"];
    const double field_of_view = view["Field of View"].as<double>();
    const double width = scene.base.width();
    const bool open = scene.boundary == Boundary::OPEN;
    view["Distance"] =
        width * (open ? OPEN_WIDTH : CLOSED_WIDTH) / (ASPECT * heightPerDistance(field_of_view));
    view["Focal Point"]["X"] = 0.5 * width;
    view["Focal Point"]["Y"] = 0.0;
    view["Focal Point"]["Z"] = width * (open ? OPEN_MIDDLE : CLOSED_MIDDLE);
    return YAML::Dump(root) + "\n";
  }
  catch (const YAML::Exception& error)
  {
    throw std::invalid_argument(std::string("no configuration of RViz: ") + error.what());
  }
}

}  // namespace ratchet_sieve
