#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "simd/batch_rows.h"

namespace ratchet_sieve
{

/// One thread's part of advancing an ensemble: loads disks into the rows of a batch, and stores them when
/// their next event is later than the requested time.
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
  template <typename Take>
  void advance(SystemState& system, std::vector<BaseEvent>& next, const BatchScene& scene, double time,
               Take&& take)
  {
    const BatchKernel& kernel = presentBatchKernel();
    share_.emplace(system.observers());
    std::uint32_t slot = 0;
    std::size_t rows = 0;
    const auto take_up = [&](std::size_t row)
    {
      while (take(slot))
        if (admit(system.collapseWatch(), slot, next[slot].time))
        {
          loadRow(system, slot, next[slot], batch_, row);
          slots_[row] = slot;
          species_[row] = system.disk(slot).species;
          return true;
        }
      return false;
    };
    while (rows < SimdBatch::ROWS && take_up(rows))
      ++rows;
    while (rows > 0)
    {
      if (share_->wantsFlights())
        takeFlights(rows);
      kernel.collide(scene, batch_, rows);
      takeOutcomes(rows);
      kernel.search(scene, batch_, rows);
      for (std::size_t row = 0; row < rows;)
      {
        if (batch_.event_time[row] <= time &&
            admit(system.collapseWatch(), slots_[row], batch_.event_time[row]))
        {
          ++row;
          continue;
        }
        storeRow(batch_, row, system, slots_[row], next[slots_[row]]);
        if (take_up(row))
          ++row;
        else if (--rows > row)
        {
          copyRow(batch_, rows, row);
          slots_[row] = slots_[rows];
          species_[row] = species_[rows];
        }
      }
    }
  }

  /// The results since the last call; hands over to the observers what this thread has observed.
  Report takeReport(Observers& observers);

private:
  /// Counts the event if it is ordinary. @return whether it is
  bool admit(CollapseWatch& watch, std::uint32_t slot, double time)
  {
    if (watch.countOrdinary(slot, time))
      return true;
    report_.not_ordinary.push_back(slot);
    return false;
  }

  /// Passes the flights that end with the next events of the first `rows` rows to the observers.
  void takeFlights(std::size_t rows);

  /// Passes the outcomes of the first `rows` rows to the observers.
  void takeOutcomes(std::size_t rows);

  SimdBatch batch_;
  std::uint32_t slots_[SimdBatch::ROWS];
  std::uint32_t species_[SimdBatch::ROWS];
  std::optional<Observers::Share> share_;
  Report report_;
};

}  // namespace ratchet_sieve
