#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace ratchet_sieve
{

/// How often each span of time occurred, in bins that are narrower than a thirtieth of their time: each
/// octave is divided into equal parts. So no logarithm of the C library decides on a bin.
class TimeHistogram
{
public:
  void add(double time)
  {
    const std::size_t bin = binOf(time);
    if (counts_.size() <= bin)
      counts_.resize(bin + 1);
    ++counts_[bin];
    ++times_;
    sum_ += time;
    squares_ += time * time;
  }

  double count() const { return static_cast<double>(times_); }
  std::optional<double> mean() const
  {
    return times_ > 0 ? std::optional<double>(sum_ / count()) : std::nullopt;
  }

  /// Of a single time.
  std::optional<double> standardDeviation() const
  {
    if (times_ < 2)
      return std::nullopt;
    return std::sqrt(std::max(0.0, squares_ - sum_ * sum_ / count()) / (count() - 1.0));
  }

  /// The time that this share of all does not exceed, interpolated within its bin.
  std::optional<double> quantile(double share) const
  {
    double rest = share * count();
    for (std::size_t bin = 0; bin < counts_.size(); ++bin)
    {
      const auto here = static_cast<double>(counts_[bin]);
      if (here > 0.0 && rest <= here)
        return edge(bin) + (edge(bin + 1) - edge(bin)) * rest / here;
      rest -= here;
    }
    return std::nullopt;
  }

  /// Calls visit(from, to, count) for every bin, from the first to the last that is not empty; its edges in
  /// s.
  template <typename Visit>
  void forEachBin(Visit&& visit) const
  {
    const auto first = std::find_if(counts_.begin(), counts_.end(), [](std::uint64_t n) { return n > 0; });
    for (auto bin = static_cast<std::size_t>(first - counts_.begin()); bin < counts_.size(); ++bin)
      visit(edge(bin), edge(bin + 1), static_cast<double>(counts_[bin]));
  }

  template <typename Archive>
  void archive(Archive& state)
  {
    state(times_, sum_, squares_, counts_);
  }

private:
  /// Times below are in the first bin, times above in the last: 2^-20 s and 2^30 s.
  static constexpr int FIRST_OCTAVE = -20;
  static constexpr int OCTAVES = 50;
  static constexpr int PARTS = 32;

  static std::size_t binOf(double time)
  {
    int exponent = 0;
    const double fraction = std::frexp(time, &exponent);  // in [1/2, 1)
    const int part = static_cast<int>((fraction - 0.5) * (2 * PARTS));
    const int bin = time > 0.0 ? (exponent - 1 - FIRST_OCTAVE) * PARTS + part : 0;
    return static_cast<std::size_t>(std::clamp(bin, 0, OCTAVES * PARTS - 1));
  }

  /// The lower edge of a bin [s].
  static double edge(std::size_t bin)
  {
    return std::ldexp(1.0 + static_cast<double>(bin % PARTS) / PARTS,
                      FIRST_OCTAVE + static_cast<int>(bin / PARTS));
  }

  std::uint64_t times_ = 0;
  double sum_ = 0.0;      ///< [s]
  double squares_ = 0.0;  ///< [s^2]
  std::vector<std::uint64_t> counts_;
};

}  // namespace ratchet_sieve
