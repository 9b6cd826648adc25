#include "observe/period_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ratchet_sieve
{
namespace
{
constexpr double PART = 1.0 / PeriodWatch::PARTS;

/// Sums relative to a velocity near the mean: otherwise the variance of nearly equal velocities would be lost
/// to cancellation.
struct Velocities
{
  Eigen::Vector2d about = Eigen::Vector2d::Zero();
  double count = 0.0;
  double weight = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();

  /// @param mass in units of the species'
  void add(const Eigen::Vector2d& velocity, double mass)
  {
    if (count == 0.0)
      about = velocity;
    const Eigen::Vector2d difference = velocity - about;
    count += 1.0;
    weight += mass;
    sum += mass * difference;
    squares += mass * difference.cwiseAbs2();
  }

  /// The mean over the disks of their mass times the square of their velocity relative to that of their
  /// centre of mass.
  std::optional<double> variance() const
  {
    if (count < 2.0)
      return std::nullopt;
    const Eigen::Vector2d mean = sum * (1.0 / weight);
    const Eigen::Vector2d spread = squares * (1.0 / weight) - mean.cwiseAbs2();
    return std::max(0.0, spread.sum()) * (weight / count);
  }
};
}  // namespace

std::vector<std::optional<double>> granularTemperatures(const SystemState& system, double time)
{
  const std::vector<SpeciesDefinition>& species = system.scene().species;
  std::vector<Velocities> velocities(species.size());
  for (const std::uint32_t slot : system.slots(true))
  {
    const Disk& disk = system.disk(slot);
    velocities[disk.species].add(vectorOf(kinematicsAt(disk, time, system.scene().gravity).velocity),
                                 system.properties(slot).mass / species[disk.species].mass);
  }
  std::vector<std::optional<double>> temperatures;
  for (std::size_t i = 0; i < species.size(); ++i)
  {
    const std::optional<double> variance = velocities[i].variance();
    temperatures.push_back(variance ? std::optional<double>(0.5 * species[i].mass * *variance)
                                    : std::nullopt);
  }
  return temperatures;
}

PeriodWatch::PeriodWatch(const SystemState& system)
    : system_(system), origin_(system.motion().drive().turns), temperatures_(system.scene().species.size())
{
}

void PeriodWatch::observe(PeriodObserver observer, double now)
{
  observer_ = std::move(observer);
  swings_ = system_.motion().swings();
  awaitPeriod(now);
}

std::optional<double> PeriodWatch::next() const
{
  const BaseMotion& motion = system_.motion();
  if (!observer_ || !swings_)
    return std::nullopt;
  // Rounding may have moved the phase past the expected one too early, by up to half a part.
  const double wanted = origin_ + part_ * PART;
  const double turns = motion.turnsAt(std::max(from_, motion.segmentStart()));
  return motion.timeOfTurns(wanted + std::ceil(turns - wanted - 0.5 * PART));
}

void PeriodWatch::sample(double now)
{
  if (part_ == 0)
    return begin(now);
  const std::vector<std::optional<double>> temperatures = granularTemperatures(system_, now);
  for (std::size_t i = 0; i < temperatures.size(); ++i)
    if (temperatures[i])
      temperatures_[i].add(*temperatures[i]);
  from_ = now;
  if (part_++ < PARTS)
    return;
  const double start = begun_;
  const double end = system_.epoch().start + now;
  observer_(
      {start, end, end - start, system_.sums().contacts.counts.collisions.since(collisions_), temperatures_});
  if (start + LEAST_SPACING > end)
    awaitPeriod(start + LEAST_SPACING - system_.epoch().start);
  else
    begin(now);
}

void PeriodWatch::begin(double now)
{
  from_ = now;
  part_ = 1;
  begun_ = system_.epoch().start + now;
  collisions_ = system_.sums().contacts.counts.collisions;
  std::fill(temperatures_.begin(), temperatures_.end(), TemperatureSum());
}

}  // namespace ratchet_sieve
