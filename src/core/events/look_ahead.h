#pragma once

#include <cstdint>

namespace ratchet_sieve
{

/// Cuts time into stretches of about so many events each, by the pace of the stretch before: within one it is
/// known in advance, but for the few that come in between, which events are next. Only time depends on it.
class LookAhead
{
public:
  explicit LookAhead(double events_per_stretch) : events_per_stretch_(events_per_stretch) {}

  double end() const { return end_; }

  /// @param now when the next event is due; @param events how many there were before
  void begin(double now, std::uint64_t events)
  {
    if (events > events_before_)
      length_ = (now - start_) * events_per_stretch_ / static_cast<double>(events - events_before_);
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
  double events_per_stretch_;
  double start_ = 0.0;
  double length_ = 0.0;
  double end_ = 0.0;
  std::uint64_t events_before_ = 0;
};

}  // namespace ratchet_sieve
