#include "ratchet_sieve/analysis/displacement_tracker.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{

/// Sums over the disks of one species.
struct Sums
{
  std::size_t disks = 0;
  double displacement = 0.0;
  double time = 0.0;
  double displacement_squared = 0.0;
  double displacement_time = 0.0;
  double time_squared = 0.0;

  void add(double dx, double dt)
  {
    ++disks;
    displacement += dx;
    time += dt;
    displacement_squared += dx * dx;
    displacement_time += dx * dt;
    time_squared += dt * dt;
  }

  DriftVelocity velocity() const
  {
    DriftVelocity velocity;
    velocity.disks = disks;
    if (disks == 0)
      return velocity;
    const double mean = displacement / time;
    velocity.mean = mean;
    if (disks > 1)
    {
      // The error of a ratio estimator: the scatter of each disk's displacement about the mean times its
      // time.
      const double count = static_cast<double>(disks);
      const double scatter =
          displacement_squared - 2.0 * mean * displacement_time + mean * mean * time_squared;
      velocity.mean_stderr = std::sqrt(std::max(0.0, scatter) * count / (count - 1.0)) / time;
    }
    return velocity;
  }
};

}  // namespace

DisplacementTracker::DisplacementTracker(std::size_t species_count, double settle, bool independent)
    : settle_(settle), independent_(independent), blocks_(species_count)
{
}

void DisplacementTracker::take(const ParticleFrame& frame)
{
  if (frame.time < settle_)
    return;
  std::vector<Sums> steps(blocks_.size());  // since the previous frame
  for (const DiskState& disk : frame.disks)
  {
    const auto [place, is_new] = tracks_.try_emplace(disk.id);
    Track& track = place->second;
    if (is_new)
      track = {disk.species, frame.time, disk.displacement, frame.time, disk.displacement};
    else
      steps[track.species].add(disk.displacement - track.last_displacement, frame.time - track.last_time);
    track.last_time = frame.time;
    track.last_displacement = disk.displacement;
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (!independent_ && steps[i].time > 0.0)
      blocks_[i].add(steps[i].displacement, steps[i].time);
}

std::vector<DriftVelocity> DisplacementTracker::velocities() const
{
  // Summed in the order of the ids, so that the same frames give the same bits.
  std::vector<std::uint32_t> ids;
  for (const auto& item : tracks_)
    ids.push_back(item.first);
  std::sort(ids.begin(), ids.end());
  std::vector<Sums> sums(blocks_.size());
  for (const std::uint32_t id : ids)
  {
    const Track& track = tracks_.at(id);
    if (track.last_time > track.first_time)
      sums[track.species].add(track.last_displacement - track.first_displacement,
                              track.last_time - track.first_time);
  }
  std::vector<DriftVelocity> velocities;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    velocities.push_back(sums[i].velocity());
    if (independent_ || !velocities[i].mean)
      continue;
    // The scatter over disks does not contain fluctuations of the layer as a whole.
    const std::optional<double> over_time = blocks_[i].standardError();
    std::optional<double>& error = velocities[i].mean_stderr;
    error = over_time ? std::optional(std::max(error.value_or(0.0), *over_time)) : std::nullopt;
  }
  return velocities;
}

}  // namespace ratchet_sieve
