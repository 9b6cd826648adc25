#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lanes/lane_rows.h"

namespace ratchet_sieve
{

/// One thread's part of advancing an ensemble: loads disks into the rows of a batch, and stores them when
/// their next event is later than the requested time.
class LaneRun
{
public:
  struct Report
  {
    std::uint64_t events = 0;
    std::vector<std::uint32_t> not_for_lanes;  ///< slots of disks whose next event is not ordinary
  };

  LaneRun() : batch_() {}

  /// Advances the disks that `take` returns, until it returns false: bool take(std::uint32_t& slot).
  template <typename Take>
  void advance(SystemState& system, const ContactExecution& execution, std::vector<BaseEvent>& next,
               const LaneScene& scene, double time, Take&& take)
  {
    const LaneKernel& kernel = presentLaneKernel();
    share_.emplace(system.observers());
    std::uint32_t slot = 0;
    std::size_t rows = 0;
    const auto take_up = [&](std::size_t row)
    {
      while (take(slot))
        if (admit(system.collapseWatch(), slot, next[slot].time))
        {
          loadRow(system, execution, slot, next[slot], batch_, row);
          slots_[row] = slot;
          species_[row] = system.disk(slot).species;
          return true;
        }
      return false;
    };
    while (rows < LaneBatch::ROWS && take_up(rows))
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
    report_.not_for_lanes.push_back(slot);
    return false;
  }

  /// Passes the flights that end with the next events of the first `rows` rows to the observers.
  void takeFlights(std::size_t rows);

  /// Passes the outcomes of the first `rows` rows to the observers.
  void takeOutcomes(std::size_t rows);

  LaneBatch batch_;
  std::uint32_t slots_[LaneBatch::ROWS];
  std::uint32_t species_[LaneBatch::ROWS];
  std::optional<Observers::Share> share_;
  Report report_;
};

}  // namespace ratchet_sieve
