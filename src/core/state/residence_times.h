#pragma once

#include <cstdint>
#include <vector>

#include "state/disk_ids.h"
#include "state/observable.h"
#include "state/per_bin.h"

namespace ratchet_sieve
{

/// How often each span of time occurred, in bins that are narrower than a thirtieth of their time: each
/// octave is divided into 32 equal parts. So no logarithm of the C library decides on a bin.
class TimeHistogram
{
public:
  void add(double time);

  double count() const { return static_cast<double>(times_); }
  std::optional<double> mean() const;

  /// Of a single time.
  std::optional<double> standardDeviation() const;

  /// The time that this share of all does not exceed, interpolated within its bin.
  std::optional<double> quantile(double share) const;

  /// Lower and upper edge [s] and count of every bin, from the first to the last that is not empty.
  std::vector<ObservedColumn> table() const;

  void archive(StateArchive& state);

private:
  std::uint64_t times_ = 0;
  double sum_ = 0.0;      ///< [s]
  double squares_ = 0.0;  ///< [s^2]
  std::vector<std::uint64_t> counts_;
};

/// The time that each disk spent in the machine, from its pour until it fell into a bin, of those that did so
/// since the end of `settle`. Disks that are still in the machine are not in it.
class ResidenceTimes final : public Observable
{
public:
  static constexpr const char* NAME = "residence_times";

  /// @param system outlives this
  explicit ResidenceTimes(const SystemState& system);

  Wishes wishes() const override
  {
    Wishes wishes;
    wishes.departures = true;
    return wishes;
  }
  void reserve(std::size_t count) override { entered_.reserve(count); }
  void entered(const Disk& disk) override;
  void left(const Departure& departure) override;
  void compact(const Compaction& compaction) override { keepSlots(entered_, compaction.kept); }
  void restart(double /*time*/) override { times_.reset(); }
  void archive(StateArchive& state) override { state(times_, entered_); }
  bool fits(std::size_t slots) const override { return entered_.size() == slots; }
  Observed observed(double time) const override;

private:
  const SystemState& system_;
  PerBin<TimeHistogram> times_;
  std::vector<double> entered_;  ///< per slot, in the run's time [s]
};

}  // namespace ratchet_sieve
