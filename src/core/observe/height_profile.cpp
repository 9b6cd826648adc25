#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

#include "model/orbit.h"
#include "observe/observable.h"
#include "ratchet_sieve/statistics/height_slices.h"
#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// The least number of parts of a period in which temperatures are taken: over a whole period, the common
/// motion of all disks would count as temperature.
constexpr std::size_t LEAST_PARTS = 16;

std::size_t partsFor(std::size_t phases)
{
  return phases * ((LEAST_PARTS + phases - 1) / phases);
}

/// Divides time into steps in which the base's acceleration hardly changes, and the periods of the drive into
/// parts. Steps begin at fixed phases, so that they do not depend on who asks.
class MotionSteps
{
public:
  /// Steps in a sine's period. Within one, a parabola through both ends with the velocities there is at most
  /// 6e-5 amplitudes from the sine: (2 pi / 32)^3 / 72 sqrt(3).
  static constexpr std::size_t PER_PERIOD = 32;

  /// The largest turn of the base within a step [rad].
  static constexpr double LARGEST_TURN = 0.01;

  /// @param parts of a period @param highest_multiple of the drive's sines
  MotionSteps(std::size_t parts, int highest_multiple)
      : parts_(parts),
        per_part_((PER_PERIOD * static_cast<std::size_t>(highest_multiple) + parts - 1) / parts)
  {
  }

  std::size_t parts() const { return parts_; }

  /// Calls visit(from, to, part) for consecutive steps from `begin` to `end`, local to the epoch [s].
  /// @pre both are within the present segment of the motion
  template <typename Visit>
  void forEach(const BaseMotion& motion, double begin, double end, Visit&& visit) const
  {
    const std::size_t per_period = parts_ * (motion.swings() ? per_part_ : 1);
    const double turn = std::abs(motion.inclinationRate());
    const double longest = turn > 0.0 ? LARGEST_TURN / turn : std::numeric_limits<double>::infinity();
    auto step =
        static_cast<std::uint64_t>(std::max(0.0, motion.turnsAt(begin)) * static_cast<double>(per_period));
    for (double from = begin; from < end; ++step)
    {
      const auto next = motion.timeOfTurns(static_cast<double>(step + 1) / static_cast<double>(per_period));
      const double last = std::min(next.value_or(end), end);
      const std::size_t part = step % per_period * parts_ / per_period;
      while (from < last)
      {
        const double to = std::min(last, from + longest);
        visit(from, to, part);
        from = to > from ? to : last;
      }
    }
  }

private:
  std::size_t parts_;
  std::size_t per_part_;  ///< steps
};

std::vector<ObservedColumn> emptyTable()
{
  return {{"phase_from", "rad", {}},
          {"phase_to", "rad", {}},
          {"from", "m", {}},
          {"to", "m", {}},
          {"number_density", "1/m^2", {}},
          {"velocity_along", "m/s", {}},
          {"velocity_up", "m/s", {}},
          {"temperature", "J", {}}};
}

std::optional<double> quotient(double part, double whole)
{
  return whole > 0.0 ? std::optional<double>(part / whole) : std::nullopt;
}

/// The height below which disks are for this share of their time, interpolated within its slice.
std::optional<double> quantile(double share, const HeightSlices& slices, std::size_t parts, double height)
{
  double rest = share * slices.time();
  for (std::size_t slice = 0; slice < slices.count(); ++slice)
  {
    double time = 0.0;
    for (std::size_t part = 0; part < parts; ++part)
      time += slices.at(slice, part).time;
    if (time > 0.0 && rest <= time)
      return height * (static_cast<double>(slice) + rest / time);
    rest -= time;
  }
  return std::nullopt;
}

/// A sum of granular temperatures over disks and time.
struct Temperature
{
  double sum = 0.0;
  double time = 0.0;

  void add(const HeightSlices::Sums& sums)
  {
    if (sums.time <= 0.0)
      return;
    sum += sums.time * sums.variance();
    time += sums.time;
  }

  std::optional<double> mean(double mass) const { return quotient(0.5 * mass * sum, time); }
};

/// Number density, mean velocity and granular temperature over the height above the base, since the end of
/// `settle`: means over time, for each of equal parts of the drive's period. Height is measured from the line
/// through the lowest corners of the teeth, along the base's normal, and velocities relative to the base.
/// Exact in time but for the steps of MotionSteps.
class HeightProfile final : public Observable
{
public:
  explicit HeightProfile(const SystemState& system)
      : system_(system),
        phases_(static_cast<std::size_t>(system.scene().height_profile.phases)),
        slice_(system.scene().height_profile.slice > 0.0 ? system.scene().height_profile.slice
                                                         : system.smallestRadius()),
        steps_(partsFor(phases_), Orbit(system.scene().base).highestMultiple()),
        sums_(noSums())
  {
  }

  unsigned subscriptions() const override { return FLIGHTS; }
  void entered(const Disk& /*disk*/, double time) override { begins_.push_back(time); }
  std::vector<double>* perSlot() override { return &begins_; }
  void flew(const Flight& flight) override
  {
    count(flight, sums_);
    begins_[flight.slot] = flight.end;
  }
  void restart(double time) override
  {
    sums_ = noSums();
    sums_.since = time;
  }
  void endSegment(double time) override { countUntil(time, sums_); }
  void rebase(double length) override
  {
    sums_.since -= length;
    for (double& begin : begins_)
      begin -= length;
  }
  void archive(StateArchive& state) override
  {
    state(sums_.since, sums_.spans);
    for (HeightSlices& slices : sums_.species)
      state(slices);
  }

  Observed observed(double time) const override
  {
    Sums sums = sums_;
    countUntil(time, sums);
    Observed result{HEIGHT_PROFILE, {}};
    for (std::size_t s = 0; s < sums.species.size(); ++s)
      result.rows.push_back(row(s, sums));
    return result;
  }

private:
  struct Sums
  {
    double since = std::numeric_limits<double>::infinity();  ///< all flights until then are counted [s]
    std::vector<double> spans;                               ///< time counted in each part of a period [s]
    std::vector<HeightSlices> species;
  };

  Sums noSums() const
  {
    Sums sums;
    sums.spans.resize(steps_.parts());
    sums.species.resize(system_.scene().species.size(), HeightSlices(slice_, steps_.parts()));
    return sums;
  }

  void count(const Flight& flight, Sums& sums) const;

  /// Counts what disks in flight do until `time`.
  void countUntil(double time, Sums& sums) const
  {
    if (!(sums.since < time))
      return;
    for (std::uint32_t slot = 0; slot < system_.disks().size(); ++slot)
      if (system_.active(slot))
        count({slot, system_.disk(slot), time}, sums);
    steps_.forEach(system_.motion(), sums.since, time,
                   [&](double from, double to, std::size_t part) { sums.spans[part] += to - from; });
    sums.since = time;
  }

  ObservedRow row(std::size_t species, const Sums& sums) const;

  /// Adds the lines of the table of one of the phases that the scene asks for.
  void addPhase(std::size_t species, std::size_t phase, const Sums& sums,
                std::vector<ObservedColumn>& table) const;

  const SystemState& system_;
  std::size_t phases_;
  double slice_;  ///< height of a slice [m]
  MotionSteps steps_;
  std::vector<double> begins_;  ///< of each disk's flight [s]
  Sums sums_;
};

void HeightProfile::count(const Flight& flight, Sums& sums) const
{
  const double begin = std::max(begins_[flight.slot], sums.since);
  if (!(begin < flight.end))
    return;
  const BaseMotion& motion = system_.motion();
  const double depth = system_.shape().depth();
  const auto seen = [&](double time)
  { return motion.at(time).see(kinematicsAt(flight.disk, time, system_.scene().gravity)); };
  const double weight =
      system_.properties(flight.slot).mass / system_.scene().species[flight.disk.species].mass;
  HeightSlices& slices = sums.species[flight.disk.species];
  BasePoint start = seen(begin);
  steps_.forEach(motion, begin, flight.end,
                 [&](double from, double to, std::size_t part)
                 {
                   const BasePoint end = seen(to);
                   slices.add({to - from,
                               {start.n() + depth, end.n() + depth},
                               {start.velocity.x(), end.velocity.x()},
                               {start.velocity.y(), end.velocity.y()},
                               weight},
                              part);
                   start = end;
                 });
}

ObservedRow HeightProfile::row(std::size_t species, const Sums& sums) const
{
  const HeightSlices& slices = sums.species[species];
  const SpeciesDefinition& definition = system_.scene().species[species];
  Temperature temperature;
  for (std::size_t slice = 0; slice < slices.count(); ++slice)
    for (std::size_t part = 0; part < steps_.parts(); ++part)
      temperature.add(slices.at(slice, part));
  std::vector<ObservedColumn> table = emptyTable();
  for (std::size_t phase = 0; phase < phases_; ++phase)
    addPhase(species, phase, sums, table);
  const double span = std::accumulate(sums.spans.begin(), sums.spans.end(), 0.0);
  return {"",
          definition.name,
          {{"disks", "", quotient(slices.time(), span)},
           {"mean_height", "m", quotient(slices.heightIntegral(), slices.time())},
           {"median_height", "m", quantile(0.5, slices, steps_.parts(), slice_)},
           {"quantile_90_height", "m", quantile(0.9, slices, steps_.parts(), slice_)},
           {"share_above", "", quotient(slices.timeAbove(), slices.time())},
           {"temperature", "J", temperature.mean(definition.mass)}},
          std::move(table)};
}

void HeightProfile::addPhase(std::size_t species, std::size_t phase, const Sums& sums,
                             std::vector<ObservedColumn>& table) const
{
  const HeightSlices& slices = sums.species[species];
  const std::size_t parts = steps_.parts() / phases_;
  const double radians = RADIANS_PER_TURN / static_cast<double>(phases_);
  const auto spans = sums.spans.begin() + static_cast<std::ptrdiff_t>(phase * parts);
  const double span = std::accumulate(spans, spans + static_cast<std::ptrdiff_t>(parts), 0.0);
  for (std::size_t slice = 0; slice < slices.count(); ++slice)
  {
    HeightSlices::Sums all;
    Temperature temperature;
    for (std::size_t part = phase * parts; part < (phase + 1) * parts; ++part)
    {
      all += slices.at(slice, part);
      temperature.add(slices.at(slice, part));
    }
    addLine(table,
            {radians * static_cast<double>(phase), radians * static_cast<double>(phase + 1),
             slice_ * static_cast<double>(slice), slice_ * static_cast<double>(slice + 1),
             quotient(all.time, span * slice_ * system_.shape().width()), quotient(all.along, all.weight),
             quotient(all.upwards, all.weight), temperature.mean(system_.scene().species[species].mass)});
  }
}
}  // namespace

std::unique_ptr<Observable> makeHeightProfile(const SystemState& system)
{
  return std::make_unique<HeightProfile>(system);
}

}  // namespace ratchet_sieve
