#include "ratchet_sieve/analysis/displacements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

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

constexpr double FEWEST_BINS = 10.0;
constexpr double MOST_BINS = 200.0;

/// Smallest width of a bin over the displacements: the edges of finer bins would round to the same value. ...
constexpr double FINEST = 1e-12;
/// ... and absolute smallest width, far below the size of an atom [m].
constexpr double SMALLEST_WIDTH = 1e-15;

/// The smallest of 1, 2, 5, 10, ... times a power of ten that is not below `width`.
double roundedUp(double width)
{
  const double power = std::pow(10.0, std::floor(std::log10(width)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= width)
      return step * power;
  return 10.0 * power;
}

/// Round edges, and twice the number of bins of Rice's rule for the largest sample (2 n^(1/3)), because the
/// early distributions are narrow compared to the late ones.
/// @return a distribution with these bins, still empty
DisplacementDistribution emptyBins(double lowest, double highest, std::size_t largest_sample)
{
  const double wanted =
      std::clamp(4.0 * std::cbrt(static_cast<double>(largest_sample)), FEWEST_BINS, MOST_BINS);
  const double range = highest - lowest;
  const double magnitude = std::max(std::abs(lowest), std::abs(highest));
  DisplacementDistribution bins;
  bins.bin_width = roundedUp(range > 0.0 ? std::max({range / wanted, FINEST * magnitude, SMALLEST_WIDTH})
                                         : std::max(magnitude, 1e-3));
  bins.first_edge = std::floor(lowest / bins.bin_width) * bins.bin_width;
  bins.counts.resize(
      static_cast<std::size_t>(std::max(0.0, std::floor((highest - bins.first_edge) / bins.bin_width))) + 1);
  return bins;
}

}  // namespace

DisplacementTracker::DisplacementTracker(std::size_t species_count, double settle, bool independent)
    : settle_(settle), independent_(independent), blocks_(species_count)
{
}

void DisplacementTracker::add(const ParticleFrame& frame)
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

std::uint64_t DisplacementDistribution::total() const
{
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

double DisplacementDistribution::density(std::size_t bin) const
{
  return static_cast<double>(counts[bin]) / (static_cast<double>(total()) * bin_width);
}

DisplacementDistributions::DisplacementDistributions(std::size_t species_count, std::vector<double> times)
    : species_count_(species_count), times_(std::move(times))
{
}

void DisplacementDistributions::add(const ParticleFrame& frame)
{
  last_ = {frame.time, std::vector<std::vector<double>>(species_count_)};
  for (const DiskState& disk : frame.disks)
    last_.displacements[disk.species].push_back(disk.displacement);
  if (next_ == times_.size() || frame.time < times_[next_])
    return;
  while (next_ < times_.size() && frame.time >= times_[next_])
    ++next_;
  snapshots_.push_back(last_);
}

std::vector<DisplacementDistribution> DisplacementDistributions::distributions() const
{
  std::vector<Snapshot> snapshots = snapshots_;
  if (snapshots.empty() || last_.time > snapshots.back().time)
    snapshots.push_back(last_);

  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  std::size_t largest_sample = 0;
  for (const Snapshot& snapshot : snapshots)
    for (const std::vector<double>& sample : snapshot.displacements)
    {
      largest_sample = std::max(largest_sample, sample.size());
      for (const double value : sample)
      {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    }
  std::vector<DisplacementDistribution> distributions;
  if (largest_sample == 0)
    return distributions;

  const DisplacementDistribution empty = emptyBins(lowest, highest, largest_sample);
  const double last_bin = static_cast<double>(empty.counts.size() - 1);
  for (const Snapshot& snapshot : snapshots)
    for (std::size_t species = 0; species < snapshot.displacements.size(); ++species)
    {
      if (snapshot.displacements[species].empty())
        continue;
      DisplacementDistribution& distribution = distributions.emplace_back(empty);
      distribution.time = snapshot.time;
      distribution.species = species;
      for (const double value : snapshot.displacements[species])
      {
        const double bin = std::floor((value - empty.first_edge) / empty.bin_width);
        ++distribution.counts[static_cast<std::size_t>(std::fmin(std::fmax(bin, 0.0), last_bin))];
      }
    }
  return distributions;
}

}  // namespace ratchet_sieve
