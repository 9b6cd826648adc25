#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "ratchet_sieve/core/block_averages.h"

namespace ratchet_sieve
{

/// x[k] = memory x[k-1] + noise, with variance 1 about a mean, and a transient that decays: a series with
/// known properties. In blocks, as a run's. Uses the generator's bits only, because the library's
/// distributions differ between implementations.
class CorrelatedSeries
{
public:
  struct Shape
  {
    double mean = 2.0;
    double memory = 0.0;     ///< correlation of neighbouring samples
    double transient = 0.0;  ///< at the first sample
    double decay = 50.0;     ///< of the transient [samples]
  };

  CorrelatedSeries(const Shape& shape, std::uint64_t seed) : shape_(shape), bits_(seed), value_(normal()) {}

  /// Adds samples up to this number.
  void extendTo(std::size_t samples)
  {
    for (; samples_ < samples; ++samples_)
    {
      const double age = static_cast<double>(samples_) / shape_.decay;
      blocks_.add(shape_.mean + shape_.transient * std::exp(-age) + value_, 1.0);
      value_ = shape_.memory * value_ + std::sqrt(1.0 - shape_.memory * shape_.memory) * normal();
    }
  }

  const BlockAverages& blocks() const { return blocks_; }

private:
  double uniform() { return (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53; }
  double normal() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(6.283185307179586 * uniform()); }

  Shape shape_;
  std::mt19937_64 bits_;
  BlockAverages blocks_;
  double value_;
  std::size_t samples_ = 0;
};

}  // namespace ratchet_sieve
