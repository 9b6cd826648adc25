#include "frame_rules.h"

#include <cmath>
#include <initializer_list>
#include <limits>

#include <fmt/format.h>

#include "ratchet_sieve/analysis/run_analysis.h"

namespace ratchet_sieve
{
namespace
{

/// Further than any disk comes in the longest run (10^9 s) at the highest speed of a scene (10^4 m/s),
/// and short of where products of two displacements overflow [m].
constexpr double FARTHEST = 1e15;

/// Disks have ids of 32 bits.
constexpr std::uint64_t MOST_IDS = std::numeric_limits<std::uint32_t>::max();

void requireSpecies(std::size_t count, const SceneDefinition& scene, const char* kind)
{
  if (count != scene.species.size())
    throw AnalysisError(fmt::format("a {} frame of {} species does not fit the scene, which has {}", kind,
                                    count, scene.species.size()));
}

void requireFinite(std::initializer_list<double> values, const char* kind, double time)
{
  for (const double value : values)
    if (!std::isfinite(value))
      throw AnalysisError(fmt::format("a {} frame at {} s holds a number that is not finite", kind, time));
}

}  // namespace

void requireSound(const ParticleFrame& frame, const SceneDefinition& scene)
{
  for (const DiskState& disk : frame.disks)
  {
    if (disk.species >= scene.species.size())
      throw AnalysisError(fmt::format("disk {} at {} s has species {}, and the scene {} of them", disk.id,
                                      frame.time, disk.species, scene.species.size()));
    if (!(std::abs(disk.displacement) <= FARTHEST))
      throw AnalysisError(
          fmt::format("disk {} at {} s has a displacement of {} m", disk.id, frame.time, disk.displacement));
  }
}

void requireSound(const BinFrame& frame, const SceneDefinition& scene)
{
  requireSpecies(frame.bins.size(), scene, "bin");
  for (const SpeciesBins& bins : frame.bins)
    if (bins.left > MOST_IDS || bins.right > MOST_IDS || bins.on_base > MOST_IDS)
      throw AnalysisError(fmt::format("a bin frame at {} s counts more disks than there can be", frame.time));
}

void requireSound(const BaseFrame& frame, const SceneDefinition&)
{
  const DriveState& base = frame.base;
  requireFinite({base.inclination, base.frequency, base.amplitude, base.commanded_inclination,
                 base.commanded_frequency, base.commanded_amplitude, base.phase, base.displacement,
                 base.velocity, base.horizontal_displacement, base.horizontal_velocity},
                "base", frame.time);
}

void requireSound(const StatisticsFrame& frame, const SceneDefinition& scene)
{
  requireSpecies(frame.means.size(), scene, "statistics");
  requireSpecies(frame.granular_temperature.size(), scene, "statistics");
  const CollisionRates& rates = frame.collision_rates;
  requireFinite({frame.window_start, frame.window_end, rates.disk_disk, rates.left_slope, rates.right_slope,
                 rates.apex, rates.wall, frame.real_time_factor, frame.max_overlap},
                "statistics", frame.time);
  for (const std::optional<double>& temperature : frame.granular_temperature)
    requireFinite({temperature.value_or(0.0)}, "statistics", frame.time);
  for (const SpeciesMeans& means : frame.means)
    requireFinite({means.mean_vx.value_or(0.0), means.mean_vx_stderr.value_or(0.0),
                   means.kinetic_translational.value_or(0.0), means.kinetic_rotational.value_or(0.0)},
                  "statistics", frame.time);
}

}  // namespace ratchet_sieve
