#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "simd/batch_rows.h"
#include "simd/ensemble_pass.h"

namespace ratchet_sieve
{

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

  /// Advances the disks that `take` returns, until it returns false: bool take(std::uint32_t& slot).
  ///
  /// Breaks off at an event that would end the run or is one too many of its disk, and where another thread
  /// does. Disks have then reached different events. If it is the last event, its disk just waits there.
  template <typename Take>
  void advance(SystemState& system, std::vector<BaseEvent>& next, const BatchScene& scene,
               const LastEvent& last, std::uint32_t most_events, PassBreak& pass_break, Take&& take)
  {
    const BatchKernel& kernel = presentBatchKernel();
    CollapseWatch& watch = system.collapseWatch();
    share_.emplace(system.observers());
    std::uint32_t slot = 0;
    std::size_t rows = 0;
    std::uint32_t events = 0;  // of each row that is loaded all the while
    const auto take_up = [&](std::size_t row)
    {
      while (take(slot))
        if (admit(watch, slot, next[slot].time, last, pass_break))
        {
          load(system, slot, next[slot], row, events);
          return true;
        }
      return false;
    };
    while (rows < SimdBatch::ROWS && take_up(rows))
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
        if (take_up(row))
          ++row;
        else if (--rows > row)
          moveRow(rows, row);
      }
    }
  }

  /// The results since the last call; `share` takes what this thread has observed.
  Report takeReport(Observers::Share& share);

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

  /// Executes the next event of each of the first `rows` rows, and finds the one after it.
  void executeEvents(const BatchKernel& kernel, const BatchScene& scene, std::size_t rows);

  /// Passes the flights that end with the next events of the first `rows` rows to the observers.
  void takeFlights(std::size_t rows);

  /// Passes the outcomes of the first `rows` rows to the observers.
  void takeOutcomes(std::size_t rows);

  SimdBatch batch_;
  std::uint32_t slots_[SimdBatch::ROWS];
  std::uint32_t species_[SimdBatch::ROWS];
  std::uint32_t loaded_[SimdBatch::ROWS];  ///< the count of events then
  std::optional<Observers::Share> share_;
  Report report_;
};

}  // namespace ratchet_sieve
