#include <algorithm>
#include <cmath>

#include "ratchet_sieve/core/layer.h"
#include "scene_warnings.h"

namespace ratchet_sieve
{
namespace
{
// Limits of how far a disk moves within a step, in smallest diameters, from docs/accuracy.md: in a layer
// steps of 1.3 are good enough; with a violent drive and steps of 1.5 energies are a third too high. Below
// 0.08 the exact method, events, is faster.
constexpr double FARTHEST = 1.4;
constexpr double NEAREST = 0.01;

constexpr double LARGEST_HALF_WIDTH = 0.2;  ///< of <V_x>, relative to the disks' speed

constexpr double TIME_OF_A_STEP = 3e-8;  ///< processor time for one disk, in 2026 [s]

void warnOfLength(const SceneDefinition& scene, double speed, SceneWarnings& warnings)
{
  const double step = scene.accuracy.step;
  const double time = 2.0 * smallestRadius(scene) / speed;
  if (step > FARTHEST * time)
    warnings.add("accuracy.step", step, "s",
                 "a disk moves by up to " + quantity(speed * step, "m") + " within a step, " +
                     number(step / time) +
                     " of the smallest diameters: many contacts are missed; use at most " +
                     quantity(FARTHEST * time, "s"));
  else if (speed > 0.0 && step < NEAREST * time)
    warnings.add(
        "accuracy.step", step, "s",
        number(1.0 / step) + " steps per simulated second take about " +
            quantity(std::ceil(TIME_OF_A_STEP / step * static_cast<double>(disksAtStart(scene))), "s") +
            " of processor time: slower than method events, which is exact",
        suggestUnit(step, 1e3,
                    [&](double longer) { return longer >= NEAREST * time && longer <= FARTHEST * time; }));
}

void warnOfMethod(const SceneDefinition& scene, double speed, SceneWarnings& warnings)
{
  const double step = scene.accuracy.step;
  if (scene.accuracy.method == Method::STEPS && scene.contact.pair_collisions)
    warnOfLength(scene, speed, warnings);
  else if (scene.accuracy.method == Method::STEPS)
    warnings.add("accuracy.method = steps: has no effect, because contact.pair_collisions is false");
  else if (step != AccuracyDefinition().step)
    warnings.add("accuracy.step", step, "s", "has no effect, because accuracy.method is events");
}

void warnOfCertainty(const SceneDefinition& scene, double speed, SceneWarnings& warnings)
{
  const AccuracyDefinition& accuracy = scene.accuracy;
  const auto coarse = [&](double half_width) { return half_width > LARGEST_HALF_WIDTH * speed; };
  if (coarse(accuracy.mean_vx))
    warnings.add("accuracy.mean_vx", accuracy.mean_vx, "m/s",
                 "too coarse for disks whose speeds reach " + quantity(speed, "m/s"),
                 suggestUnit(accuracy.mean_vx, 1e-3, [&](double half_width) { return !coarse(half_width); }));
  if (accuracy.mean_vx > 0.0 && empties(scene))
    warnings.add(
        "accuracy.mean_vx", accuracy.mean_vx, "m/s",
        "an open base that is not fed empties, and has no steady <V_x>; boundary must be periodic or "
        "feed.rate above 0");
  const std::string quality = "accuracy.quality = " + scalarText(accuracy.quality) + ": cannot be reached, ";
  if (accuracy.quality > 0.0 && scene.boundary == Boundary::PERIODIC)
    warnings.add(quality + "because no disk leaves a periodic base; boundary must be open or walled");
  else if (accuracy.quality > 0.0 && scene.species.size() < 2)
    warnings.add(quality + "because Q compares species; there must be two or more");
}
}  // namespace

void warnOfAccuracy(const SceneDefinition& scene, double speed, SceneWarnings& warnings)
{
  warnOfMethod(scene, speed, warnings);
  warnOfCertainty(scene, speed, warnings);
}

}  // namespace ratchet_sieve
