#include "state/residence_times.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// Times below are in the first bin, times above in the last: 2^-20 s and 2^30 s.
constexpr int FIRST_OCTAVE = -20;
constexpr int OCTAVES = 50;
constexpr int PARTS = 32;

std::size_t timeBin(double time)
{
  int exponent = 0;
  const double fraction = std::frexp(time, &exponent);  // in [1/2, 1)
  const int part = static_cast<int>((fraction - 0.5) * (2 * PARTS));
  const int bin = time > 0.0 ? (exponent - 1 - FIRST_OCTAVE) * PARTS + part : 0;
  return static_cast<std::size_t>(std::clamp(bin, 0, OCTAVES * PARTS - 1));
}

/// The lower edge of a bin [s].
double timeEdge(std::size_t bin)
{
  return std::ldexp(1.0 + static_cast<double>(bin % PARTS) / PARTS,
                    FIRST_OCTAVE + static_cast<int>(bin / PARTS));
}
}  // namespace

void TimeHistogram::add(double time)
{
  const std::size_t bin = timeBin(time);
  if (counts_.size() <= bin)
    counts_.resize(bin + 1);
  ++counts_[bin];
  ++times_;
  sum_ += time;
  squares_ += time * time;
}

std::optional<double> TimeHistogram::mean() const
{
  return times_ > 0 ? std::optional<double>(sum_ / count()) : std::nullopt;
}

std::optional<double> TimeHistogram::standardDeviation() const
{
  if (times_ < 2)
    return std::nullopt;
  return std::sqrt(std::max(0.0, squares_ - sum_ * sum_ / count()) / (count() - 1.0));
}

std::optional<double> TimeHistogram::quantile(double share) const
{
  double rest = share * count();
  for (std::size_t bin = 0; bin < counts_.size(); ++bin)
  {
    const auto here = static_cast<double>(counts_[bin]);
    if (here > 0.0 && rest <= here)
      return timeEdge(bin) + (timeEdge(bin + 1) - timeEdge(bin)) * rest / here;
    rest -= here;
  }
  return std::nullopt;
}

std::vector<ObservedColumn> TimeHistogram::table() const
{
  std::vector<ObservedColumn> columns{{"from", "s", {}}, {"to", "s", {}}, {"count", "", {}}};
  const auto first = std::find_if(counts_.begin(), counts_.end(), [](std::uint64_t n) { return n > 0; });
  for (auto bin = static_cast<std::size_t>(first - counts_.begin()); bin < counts_.size(); ++bin)
  {
    addLine(columns, {timeEdge(bin), timeEdge(bin + 1), static_cast<double>(counts_[bin])});
  }
  return columns;
}

void TimeHistogram::archive(StateArchive& state)
{
  state(times_, sum_, squares_, counts_);
}

ResidenceTimes::ResidenceTimes(const SystemState& system)
    : system_(system), times_(system.scene().species.size())
{
}

void ResidenceTimes::entered(const Disk& disk)
{
  entered_.push_back(system_.epoch().start + disk.time);
}

void ResidenceTimes::left(const Departure& departure)
{
  times_.of(departure).add(system_.epoch().start + departure.time - entered_[departure.slot]);
}

Observed ResidenceTimes::observed(double /*time*/) const
{
  return times_.observed(NAME, system_,
                         [](const TimeHistogram& times)
                         {
                           return ObservedRow{"",
                                              "",
                                              {{"count", "", times.count()},
                                               {"mean", "s", times.mean()},
                                               {"standard_deviation", "s", times.standardDeviation()},
                                               {"quantile_10", "s", times.quantile(0.1)},
                                               {"median", "s", times.quantile(0.5)},
                                               {"quantile_90", "s", times.quantile(0.9)}},
                                              times.table()};
                         });
}

}  // namespace ratchet_sieve
