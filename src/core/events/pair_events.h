#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "events/disk_cells.h"
#include "events/event_queue.h"
#include "state/contact_execution.h"
#include "state/contact_prediction.h"

namespace ratchet_sieve
{

/// The first event of each type on a disk's present flight.
struct alignas(64) DiskPrediction
{
  PairContact pair;
  std::uint32_t partner_event_count = 0;  ///< the partner's count at the prediction
  CellEdge edge = CellEdge::NONE;
  double cell_time = EventQueue::NEVER;  ///< leaves its cell; if there is no edge: not before
  BaseEvent base;

  double earliest() const { return std::min({pair.time, cell_time, base.time}); }

  void archive(StateArchive& state) { state(pair, partner_event_count, edge, cell_time, base); }
};

/// Cells from `first` to `last` column, which may be outside of the grid.
struct ColumnSpan
{
  std::int32_t first;
  std::int32_t last;
};

/// What a layer's events read and change besides the system.
struct PairLayer
{
  explicit PairLayer(SystemState& system) : state(system), cells(system)
  {
    predictions.reserve(system.disks().size());
  }

  bool isStale(const DiskPrediction& p) const
  {
    return state.disk(p.pair.partner).eventCount() != p.partner_event_count;
  }

  SystemState& state;
  DiskCells cells;
  SlotArray<DiskPrediction> predictions;  ///< per disk
};

/// The events of colliding disks. Each disk has one event in the queue, its earliest: a pair contact, a base
/// contact or a cell crossing. A predicted pair contact is stale if the partner's flight has changed since;
/// that is checked when the event is due, and the disk is then searched for pairs again (Lubachevsky, J.
/// Comput. Phys. 94, 255 (1991)). Ties within a disk are resolved in the order pair, base, cell; ties between
/// disks by the smaller slot.
///
/// The base is searched lazily, only up to the disk's next other event, because most flights end in a pair
/// contact first.
///
/// No pair is missed, whatever the size of the cells. Whenever a disk begins a flight or enters a cell, it is
/// searched for contacts with all disks in adjacent cells, without a limit in time. Disks in cells that do
/// not touch are further apart than the largest diameter. So if two disks come into contact, the one that
/// last began its flight or entered its cell was searched against the other. On a ring of one column, the
/// cell is as wide as the widths that it extends beyond its ends, and all images that can be within it are
/// searched (PeriodicImageSearch).
///
/// @tparam Queue EventQueue, or SlotQueue for a part of the disks
template <typename Queue>
class PairEvents
{
public:
  /// @param layer, queue outlive this
  /// @param buffer as in SystemState::collided()
  PairEvents(PairLayer& layer, Queue& queue, ThreadBuffer* buffer)
      : layer_(layer),
        state_(layer.state),
        cells_(layer.cells),
        queue_(queue),
        prediction_(layer.state),
        execution_(layer.state, buffer),
        buffer_(buffer)
  {
  }

  /// Executes the earliest event of a disk, which is at `now`.
  void process(std::uint32_t slot, double now)
  {
    ++events_;
    DiskPrediction& p = predicted(slot);
    if (p.pair.time <= now)
      processPair(slot, now);
    else if (p.base.feature && p.base.time <= now)
      processBase(slot, now);
    else if (p.edge != CellEdge::NONE && p.cell_time <= now)
      crossEdge(slot, now);
    else
      refresh(slot);
  }

  /// The columns of the disks and cells that process() reads or changes: at most two to either side of the
  /// disk's. @pre DiskCells::seesNextColumnOnly()
  ColumnSpan touched(std::uint32_t slot, double now) const
  {
    const std::int32_t column = cells_.grid().columnOf(slot);
    const DiskPrediction& p = layer_.predictions[slot];
    if (p.pair.time <= now)
    {
      if (layer_.isStale(p))
        return {column - 1, column + 1};
      // The partner is on the same flight since it was in an adjacent cell, and has come closer.
      std::int32_t partner = cells_.grid().columnOf(p.pair.partner) - column;
      if (partner > 1 || partner < -1)
        partner = partner > 0 ? -1 : 1;  // across the seam
      return {column - 1 + std::min(partner, 0), column + 1 + std::max(partner, 0)};
    }
    if (p.base.feature && p.base.time <= now)
      return p.base.feature.isEnd() ? ColumnSpan{column - 2, column + 2} : ColumnSpan{column - 1, column + 1};
    if (p.edge == CellEdge::LEFT)
      return {column - 2, column + 1};
    if (p.edge == CellEdge::RIGHT)
      return {column - 1, column + 2};
    return {column - 1, column + 1};
  }

  /// Predicts everything for a new flight.
  void predict(std::uint32_t slot, double now)
  {
    searchPairs(slot, now);
    DiskPrediction& p = predicted(slot);
    p.edge = CellEdge::NONE;
    p.cell_time = now;
    p.base = {now, {}};
    refresh(slot);
  }

  /// See ContactPrediction::renew().
  void renew() { prediction_.renew(); }

  std::uint64_t events() const { return events_; }

  /// The number of events and cell crossings since the last call.
  std::uint64_t takeEvents() { return std::exchange(events_, 0); }
  std::uint64_t takeCrossings() { return std::exchange(crossings_, 0); }

private:
  DiskPrediction& predicted(std::uint32_t slot) { return layer_.predictions[slot]; }

  void processPair(std::uint32_t slot, double now)
  {
    const DiskPrediction p = predicted(slot);
    if (layer_.isStale(p) || !execution_.collidePair(slot, p.pair.partner, p.pair.shift, now).closed)
    {
      searchPairs(slot, now);
      refresh(slot);
      return;
    }
    predict(slot, now);
    predict(p.pair.partner, now);
  }

  void processBase(std::uint32_t slot, double now)
  {
    const BaseFeature feature = predicted(slot).base.feature;
    if (!execution_.handleBaseEvent(slot, feature, now, prediction_.base()))
    {
      predicted(slot).base = {now, {}};
      return refresh(slot);
    }
    if (state_.active(slot))
    {
      if (feature.isEnd())
        cells_.replace(slot, now, buffer_);
      return predict(slot, now);
    }
    cells_.remove(slot);
    predicted(slot) = DiskPrediction();
    queue_.update(slot, EventQueue::NEVER);
  }

  void crossEdge(std::uint32_t slot, double now)
  {
    ++crossings_;
    const CellEdge edge = predicted(slot).edge;
    if (cells_.cross(slot, edge, now, buffer_))
      return predict(slot, now);
    searchPairsIn(slot, edge, now);
    predicted(slot).edge = CellEdge::NONE;
    predicted(slot).cell_time = now;
    refresh(slot);
  }

  void searchPairs(std::uint32_t slot, double now)
  {
    predicted(slot).pair = PairContact();
    searchPairsIn(slot, CellEdge::NONE, now);
  }

  void searchPairsIn(std::uint32_t slot, CellEdge entered, double now)
  {
    DiskPrediction& p = predicted(slot);
    const PairSearch search = prediction_.pairsOf(slot, now);
    const int ring_shifts = cells_.ringShifts();
    const std::int32_t* const images = cells_.images(slot);
    cells_.grid().visit(slot, entered, near_,
                        [&](const std::uint32_t* others, std::size_t count, int shift)
                        {
                          const PairContact found =
                              ring_shifts > 0     ? search.firstOnRing(others, count, ring_shifts)
                              : images != nullptr ? search.firstAmong(others, count, shift, images)
                                                  : search.firstAmong(others, count, shift);
                          if (!found.isBefore(p.pair))
                            return;
                          p.pair = found;
                          p.partner_event_count = state_.disk(found.partner).event_count;
                        });
  }

  /// Continues the searches for cell edges and base contacts up to the disk's next other event, and queues
  /// the earliest.
  void refresh(std::uint32_t slot)
  {
    DiskPrediction& p = predicted(slot);
    // The two usually begin at the same time.
    const Kinematics point = state_.flown(slot, p.base.time);
    if (p.edge == CellEdge::NONE && p.cell_time < p.pair.time)
    {
      const DiskCells::Crossing crossing =
          p.cell_time == point.time ? cells_.nextCrossing(slot, point, p.pair.time)
                                    : cells_.nextCrossing(slot, state_.flown(slot, p.cell_time), p.pair.time);
      p.edge = crossing.edge;
      p.cell_time = crossing.time;
    }
    const double others = std::min(p.pair.time, p.cell_time);
    if (!p.base.feature && p.base.time < others)
      p.base =
          cells_.aboveBase(slot) ? BaseEvent{others, {}} : prediction_.nextBaseEvent(slot, point, others);
    queue_.update(slot, std::min(others, p.base.time));
  }

  PairLayer& layer_;
  SystemState& state_;
  DiskCells& cells_;
  Queue& queue_;
  ContactPrediction prediction_;
  ContactExecution execution_;
  ThreadBuffer* buffer_;
  std::uint64_t events_ = 0;
  std::uint64_t crossings_ = 0;
  std::vector<std::uint32_t> near_;  ///< candidates of the neighbour search
};

}  // namespace ratchet_sieve
