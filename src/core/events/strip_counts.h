#pragma once

#include <chrono>
#include <cstdint>

namespace ratchet_sieve
{

/// What strips of a layer have done so far, those windows included that were repeated with a single queue.
struct StripCounts
{
  std::uint64_t events = 0;
  std::uint64_t windows = 0;

  /// The events that follow one another if each strip has a thread: in each window those of the strip with
  /// the most events, then those of the cut with the most.
  std::uint64_t critical_events = 0;

  double meeting = 0.0;  ///< sum over the threads of the time between phases, waiting or working alone [s]
  double alone = 0.0;    ///< time for copies, by two threads, and in which one counted and handed over [s]
};

/// Adds the time until it is destroyed to a sum [s].
class TimeSpent
{
public:
  explicit TimeSpent(double& sum) : sum_(sum), start_(std::chrono::steady_clock::now()) {}
  ~TimeSpent() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  TimeSpent(const TimeSpent&) = delete;
  TimeSpent& operator=(const TimeSpent&) = delete;

private:
  double& sum_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace ratchet_sieve
