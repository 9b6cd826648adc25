#include <algorithm>
#include <limits>

#include "doubts.h"

namespace ratchet_sieve
{
namespace
{
/// So many of the smallest diameters within a step: what a disk meets on such a way, few overlaps at its end
/// tell.
constexpr double FARTHEST = 2.0;
}  // namespace

void doubtSteps(const SceneDefinition& scene, double speed, Doubts& doubts)
{
  const double step = scene.accuracy.step;
  const bool by_steps = scene.accuracy.method == Method::STEPS;
  if (!by_steps && step != AccuracyDefinition().step)
    doubts.add("accuracy.step", step, "s", "of no effect, for accuracy.method is events");
  if (!by_steps)
    return;
  if (!scene.contact.pair_collisions)
    return doubts.add(
        "accuracy.method = steps: of no effect, for disks that do not see each other are advanced from "
        "event to event");
  double diameter = std::numeric_limits<double>::infinity();
  for (const SpeciesDefinition& species : scene.species)
    diameter = std::min(diameter, 2.0 * species.radius);
  const auto far = [&](double time) { return speed * time > FARTHEST * diameter; };
  if (far(step))
    doubts.add("accuracy.step", step, "s",
               "within which a disk moves by up to " + quantity(speed * step, "m") + ", " +
                   number(speed * step / diameter) + " of the smallest diameters: many contacts are missed",
               meant(step, 1e-3, [&](double time) { return !far(time); }));
}

}  // namespace ratchet_sieve
