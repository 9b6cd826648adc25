#pragma once

#include <cstdint>

namespace ratchet_sieve
{

/// Divides time into windows with about a given number of events each, by the event rate of the previous
/// window. Most events of a window are known at its start, so that their memory can be prefetched. Results do
/// not depend on it.
class PrefetchWindow
{
public:
  explicit PrefetchWindow(double events_per_window) : events_per_window_(events_per_window) {}

  double end() const { return end_; }

  /// @param now time of the next event; @param events number of events so far
  void begin(double now, std::uint64_t events)
  {
    if (events > events_before_)
      length_ = (now - start_) * events_per_window_ / static_cast<double>(events - events_before_);
    start_ = now;
    events_before_ = events;
    end_ = now + length_;
  }

  /// Subtracts `length` from every time.
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
