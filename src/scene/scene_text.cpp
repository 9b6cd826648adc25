#include "ratchet_sieve/scene/scene_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{
/// Upper bound of the memory per disk in a large run, including neighbours, events and sums [bytes].
constexpr double MEMORY_PER_DISK = 500.0;
}  // namespace

std::string planText(const Plan& plan)
{
  std::string line = plan.pairs ? "pairs" : "no pairs (disks do not collide with each other)";
  if (plan.steps)
    line += ", by steps (contacts that begin and end within a step are missed)";
  line += plan.spin ? ", spin" : ", no spin (no friction turns a disk)";
  line += plan.drive ? ", drive" : ", no drive (the base stands still)";
  if (plan.orbit)
    line += " with a horizontal part or harmonics, or along the base's axes";
  line += plan.contact_times ? ", contact times" : ", no contact times (contact_duration is 0)";
  line += ", no base search above the base's reach";
  line += plan.simd ? ", SIMD"
                    : ", no SIMD (only for independent disks without contact times on a periodic sawtooth "
                      "with a vertical sine drive)";
  return line;
}

std::string sizeText(const SceneDefinition& scene)
{
  const auto disks = static_cast<double>(disksAtStart(scene));
  std::string text = countText(disksAtStart(scene), "disk") + ", ";
  if (feedRate(scene) > 0.0)
    text += fmt::format("fed at {:.3g}/s, ", feedRate(scene));
  if (scene.contact.pair_collisions && disks > 0.0)
    text += fmt::format("at rest a layer of about {:.3g} m, ", settledLayer(scene));
  return text +
         fmt::format("about {} MB of memory", std::lround(std::max(1.0, 1e-6 * MEMORY_PER_DISK * disks)));
}

}  // namespace ratchet_sieve
