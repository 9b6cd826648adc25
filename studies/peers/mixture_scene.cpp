#include "mixture_scene.h"

#include <cmath>

#include "scenes.h"

namespace ratchet_sieve::peers
{
namespace
{
constexpr int DISKS_PER_SPECIES = 262;
constexpr double TWO_PI = 6.283185307179586;
}  // namespace

SceneDefinition mixtureScene(std::uint64_t seed)
{
  SceneDefinition scene = test::mixture(DISKS_PER_SPECIES);
  scene.seed = seed;
  return scene;
}

const ContactCoefficients& contactOf(const SceneDefinition& scene)
{
  return scene.species.front().contact;
}

std::vector<DiskState> startOf(const SceneDefinition& scene)
{
  return Simulation(scene).disks();
}

std::vector<Point> outline(const BaseDefinition& base)
{
  std::vector<Point> points;
  for (int tooth = -EXTRA_TEETH; tooth < base.teeth + EXTRA_TEETH; ++tooth)
  {
    points.push_back({tooth * base.tooth_width, 0.0});
    points.push_back({(tooth + base.asymmetry) * base.tooth_width, base.tooth_height});
  }
  points.push_back({(base.teeth + EXTRA_TEETH) * base.tooth_width, 0.0});
  return points;
}

BaseState baseAt(const BaseDefinition& base, double time)
{
  const double omega = TWO_PI * base.frequency;
  const double phase = omega * time + base.phase;
  return {base.amplitude * std::sin(phase), base.amplitude * omega * std::cos(phase)};
}

}  // namespace ratchet_sieve::peers
