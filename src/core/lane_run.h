#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/lane_rows.h"

namespace ratchet_sieve
{

/// One thread's share in advancing an ensemble: disks are taken up into the rows of a batch, and put back
/// when their next event is later than asked for.
class LaneRun
{
public:
  struct Outcome
  {
    std::uint64_t events = 0;
    CollisionCounts collisions;
    std::vector<std::uint64_t> contacts;  ///< per species
    double max_overlap = 0.0;
    std::vector<CollisionRecord> records;      ///< only where somebody watches
    std::vector<std::uint32_t> not_for_lanes;  ///< disks whose next event is due, and not an ordinary one
  };

  LaneRun() : batch_() {}

  /// Advances the disks that `take` hands out, until it has no more: bool take(std::uint32_t& id).
  template <typename Take>
  void advance(Machine& machine, std::vector<BaseEvent>& next, const LaneScene& scene, double time,
               Take&& take)
  {
    const LaneKernel& kernel = presentLaneKernel();
    met_.resize(machine.scene().species.size());
    const bool watched = static_cast<bool>(machine.collisionObserver());
    std::uint32_t id = 0;
    std::size_t rows = 0;
    const auto take_up = [&](std::size_t row)
    {
      while (take(id))
        if (admit(machine, id, next[id].time))
        {
          loadRow(machine, id, next[id], batch_, row);
          ids_[row] = id;
          species_[row] = machine.disk(id).species;
          return true;
        }
      return false;
    };
    while (rows < LaneBatch::ROWS && take_up(rows))
      ++rows;
    while (rows > 0)
    {
      kernel.meet(scene, batch_, rows);
      takeAccount(rows);
      if (watched)
        record(machine, rows);
      kernel.search(scene, batch_, rows);
      for (std::size_t row = 0; row < rows;)
      {
        if (batch_.due[row] <= time && admit(machine, ids_[row], batch_.due[row]))
        {
          ++row;
          continue;
        }
        storeRow(batch_, row, machine, ids_[row], next[ids_[row]]);
        if (take_up(row))
          ++row;
        else if (--rows > row)
        {
          copyRow(batch_, rows, row);
          ids_[row] = ids_[rows];
          species_[row] = species_[rows];
        }
      }
    }
  }

  /// What has come of it since the last time.
  Outcome takeOutcome();

private:
  /// Counts the event, if it is an ordinary one.
  bool admit(Machine& machine, std::uint32_t id, double due)
  {
    if (machine.collapseWatch().countOrdinary(id, due))
      return true;
    outcome_.not_for_lanes.push_back(id);
    return false;
  }

  using Contacts = std::array<std::uint64_t, LANE_APEX + 1>;  ///< by LaneFeature

  void takeAccount(std::size_t rows);
  void record(const Machine& machine, std::size_t rows);

  LaneBatch batch_;
  std::uint32_t ids_[LaneBatch::ROWS];
  std::uint32_t species_[LaneBatch::ROWS];
  std::vector<Contacts> met_;  ///< per species
  Outcome outcome_;
};

}  // namespace ratchet_sieve
