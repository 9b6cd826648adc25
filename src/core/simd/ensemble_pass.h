#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <mutex>

namespace ratchet_sieve
{

/// The last event that is executed, in the order of a single queue: by time, then by slot.
struct LastEvent
{
  double time;  ///< [s]
  std::uint32_t slot = std::numeric_limits<std::uint32_t>::max();

  bool isAtOrAfter(double event_time, std::uint32_t event_slot) const
  {
    return event_time < time || (event_time == time && event_slot <= slot);
  }
  bool isAt(double event_time, std::uint32_t event_slot) const
  {
    return event_time == time && event_slot == slot;
  }
};

/// The event at which a pass breaks off, because it would end the run or is one too many of its disk:
/// the earliest that a thread has found.
class PassBreak
{
public:
  /// Whether there is one.
  explicit operator bool() const { return is_set_.load(std::memory_order_relaxed); }

  void set(const LastEvent& event)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!*this || event_.isAtOrAfter(event.time, event.slot))
      event_ = event;
    is_set_.store(true, std::memory_order_relaxed);
  }

  /// @pre no thread is at work
  LastEvent take()
  {
    is_set_ = false;
    return event_;
  }

private:
  std::atomic<bool> is_set_{false};
  std::mutex mutex_;
  LastEvent event_{};
};

}  // namespace ratchet_sieve
