#pragma once

#include <cstdint>

namespace ratchet_sieve
{

/// Divides time into windows of about so many events each, by the rate of the window before. Which events
/// come within one is known at its start, but for the few that are predicted meanwhile, so that what they
/// need can be prefetched. Results do not depend on it.
class PrefetchWindow
{
public:
  explicit PrefetchWindow(double events_per_window) : events_per_window_(events_per_window) {}

  double end() const { return end_; }

  /// @param now the time of the next event; @param events how many there were before
  void begin(double now, std::uint64_t events)
  {
    if (events > events_before_)
      length_ = (now - start_) * events_per_window_ / static_cast<double>(events - events_before_);
    start_ = now;
    events_before_ = events;
    end_ = now + length_;
  }

  /// Moves every time back by `length`.
  void rebase(double length)
  {
    start_ -= length;
    end_ -= length;
  }

private:
  double events_per_window_;
  double start_ = 0.0;
  double length_ = 0.0;
  double end_ = 0.0;
  std::uint64_t events_before_ = 0;
};

}  // namespace ratchet_sieve
