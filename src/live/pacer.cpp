#include "ratchet_sieve/live/pacer.h"

#include <algorithm>

namespace ratchet_sieve
{
namespace
{
/// A simulation that lags wall time by more than this [s] continues from its present time.
constexpr double TOLERATED_LAG = 0.1;

/// Strides are not stretched beyond this: a light scene needs no more [s of simulated time].
constexpr double LONGEST_STRIDE = 10.0;

/// A floor that lets the very heaviest scenes move on [s of simulated time].
constexpr double SHORTEST_STRIDE = 1e-7;

double seconds(Pacer::Clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}
}  // namespace

void Pacer::anchor(double elapsed, Clock::time_point now)
{
  anchor_elapsed_ = elapsed;
  anchor_wall_ = now;
}

void Pacer::setFactor(double real_time_factor, double elapsed, Clock::time_point now)
{
  factor_ = real_time_factor;
  anchor(elapsed, now);
}

double Pacer::allowed(double elapsed, Clock::time_point now)
{
  const double longest = elapsed + stride_;
  if (factor_ <= 0.0)
    return longest;
  const double target = anchor_elapsed_ + factor_ * seconds(now - anchor_wall_);
  if (target - elapsed > factor_ * TOLERATED_LAG)
  {
    lost_ += (target - elapsed) / factor_;
    anchor(elapsed, now);
  }
  return std::min(target, longest);
}

double Pacer::wait(double elapsed, Clock::time_point now) const
{
  if (factor_ <= 0.0)
    return 0.0;
  const double due = (elapsed - anchor_elapsed_) / factor_ - seconds(now - anchor_wall_);
  return std::min(std::max(due, 0.0), LONGEST_WAIT);
}

void Pacer::advanced(double simulated, double wall)
{
  if (wall > LONGEST_WAIT)
    stride_ = std::max(0.5 * stride_, SHORTEST_STRIDE);
  else if (wall < 0.25 * LONGEST_WAIT && simulated >= 0.99 * stride_)
    stride_ = std::min(2.0 * stride_, LONGEST_STRIDE);
}

}  // namespace ratchet_sieve
