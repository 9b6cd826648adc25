#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "simd/batch_rows.h"

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

/// One thread's part of advancing an ensemble: loads disks into the rows of a batch, and stores them when
/// their next event is after the last one.
class BatchRun
{
public:
  struct Report
  {
    std::uint64_t events = 0;
    std::vector<std::uint32_t> not_ordinary;  ///< slots of disks whose next event is not ordinary
  };

  BatchRun() : batch_() {}

  /// Advances the disks that `next_disk` gives, until it returns false: bool next_disk(std::uint32_t& slot).
  ///
  /// Breaks off at an event that would end the run or is one too many of its disk, and where another thread
  /// does. Disks have then reached different events. If it is the last event, its disk just waits there.
  template <typename NextDisk>
  void advance(const BatchKernel& kernel, SystemState& system, std::vector<BaseEvent>& next,
               const BatchScene& scene, const LastEvent& last, std::uint32_t most_events,
               PassBreak& pass_break, NextDisk&& next_disk)
  {
    CollapseWatch& watch = system.collapseWatch();
    buffer_ = system.log().buffer();
    std::uint32_t slot = 0;
    std::size_t rows = 0;
    std::uint32_t events = 0;  // of each row that is loaded all the while
    const auto refill = [&](std::size_t row)
    {
      while (next_disk(slot))
        if (admit(watch, slot, next[slot].time, last, pass_break))
        {
          load(system, slot, next[slot], row, events);
          return true;
        }
      return false;
    };
    while (rows < SimdBatch::ROWS && refill(rows))
      ++rows;
    while (rows > 0 && !pass_break)
    {
      executeEvents(kernel, scene, rows);
      ++events;
      for (std::size_t row = 0; row < rows;)
      {
        const double time = batch_.event_time[row];
        if (last.isAtOrAfter(time, slots_[row]))
        {
          if (events - loaded_[row] >= most_events)
            breakOff(slots_[row], time, last, pass_break);
          else if (admit(watch, slots_[row], time, last, pass_break))
          {
            ++row;
            continue;
          }
        }
        storeRow(batch_, row, system, slots_[row], next[slots_[row]]);
        if (refill(row))
          ++row;
        else if (--rows > row)
          moveRow(rows, row);
      }
    }
  }

  /// The results since the last call; `buffer` takes what this thread has observed.
  Report takeReport(ThreadBuffer& buffer)
  {
    if (buffer_)
      buffer.merge(std::move(*buffer_));
    buffer_.reset();
    return std::exchange(report_, Report());
  }

private:
  /// Counts the event if it is ordinary. @return whether it is
  bool admit(CollapseWatch& watch, std::uint32_t slot, double time, const LastEvent& last,
             PassBreak& pass_break)
  {
    if (watch.countOrdinary(slot, time))
      return true;
    if (watch.endsAt(slot, time))
      breakOff(slot, time, last, pass_break);
    else
      report_.not_ordinary.push_back(slot);
    return false;
  }

  static void breakOff(std::uint32_t slot, double time, const LastEvent& last, PassBreak& pass_break)
  {
    if (!last.isAt(time, slot))
      pass_break.set({time, slot});
  }

  void load(const SystemState& system, std::uint32_t slot, const BaseEvent& next, std::size_t row,
            std::uint32_t events)
  {
    loadRow(system, slot, next, batch_, row);
    slots_[row] = slot;
    species_[row] = system.disk(slot).species;
    loaded_[row] = events;
  }

  void moveRow(std::size_t from, std::size_t to)
  {
    copyRow(batch_, from, to);
    slots_[to] = slots_[from];
    species_[to] = species_[from];
    loaded_[to] = loaded_[from];
  }

  /// Executes the next event of each of the first `rows` rows, passes the flights that end with it and the
  /// outcomes to the observers, and finds the event after it.
  void executeEvents(const BatchKernel& kernel, const BatchScene& scene, std::size_t rows)
  {
    for (std::size_t row = 0; row < rows && buffer_->wantsFlights(); ++row)
    {
      Disk disk;
      readState(batch_, row, disk);
      disk.species = species_[row];
      buffer_->flew({slots_[row], disk, batch_.event_time[row]});
    }
    kernel.collide(scene, batch_, rows);
    report_.events += rows;
    buffer_->collided(
        rows, [&](std::size_t row) { return outcomeOf(scene, batch_, row, slots_[row], species_[row]); });
    kernel.search(scene, batch_, rows);
  }

  SimdBatch batch_;
  std::uint32_t slots_[SimdBatch::ROWS];
  std::uint32_t species_[SimdBatch::ROWS];
  std::uint32_t loaded_[SimdBatch::ROWS];  ///< the count of events then
  std::optional<ThreadBuffer> buffer_;
  Report report_;
};

}  // namespace ratchet_sieve
