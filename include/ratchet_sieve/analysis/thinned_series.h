#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace ratchet_sieve
{

/// A series of samples that keeps at most a fixed number of them: every 2^k-th, and the last.
template <typename Sample>
class ThinnedSeries
{
public:
  /// @param capacity largest number to keep; even, at least 2
  explicit ThinnedSeries(std::size_t capacity = 4096) : capacity_(capacity) {}

  void take(Sample sample)
  {
    if (taken_++ % stride_ != 0)
    {
      last_ = std::move(sample);
      return;
    }
    last_.reset();
    kept_.push_back(std::move(sample));
    if (kept_.size() > capacity_)
      thin();
  }

  /// In the order in which they came.
  std::vector<Sample> samples() const
  {
    std::vector<Sample> all = kept_;
    if (last_)
      all.push_back(*last_);
    return all;
  }

private:
  /// Keeps every second sample. @pre the number of samples is odd, so that the last one stays
  void thin()
  {
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i)
      kept_[i] = std::move(kept_[2 * i]);
    kept_.resize((kept_.size() + 1) / 2);
    stride_ *= 2;
  }

  std::size_t capacity_;
  std::size_t taken_ = 0;
  std::size_t stride_ = 1;
  std::vector<Sample> kept_;
  std::optional<Sample> last_;  ///< if it is not among those kept
};

}  // namespace ratchet_sieve
