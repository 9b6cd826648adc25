#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "search/cell_grid.h"
#include "search/cell_layout.h"
#include "search/quadratic.h"
#include "state/machine_state.h"

namespace ratchet_sieve
{

/// Which cell each active disk of a machine is in, and when it leaves that. Disks in cells that do not touch
/// are further apart than the largest diameter.
///
/// The cells are made for a shaken layer. Where disks fly so far and fast that most events are crossings,
/// the grid is rebuilt at the end of an epoch, as LayoutCosts finds it cheapest for the disks as they are
/// then.
class DiskCells
{
public:
  enum class Edge : std::uint8_t
  {
    NONE,
    LEFT,
    RIGHT,
    LOWER,
    UPPER
  };

  struct Crossing
  {
    Edge edge = Edge::NONE;
    double time = 0.0;  ///< without an edge: not before
  };

  /// @param state outlives this; its disks are in no cell until rebuild() or add()
  explicit DiskCells(MachineState& state);

  /// A grid for the disks at slots below `count`, on the base as it stands, with all of them in it.
  void rebuild(std::size_t count, double time);

  /// How many slots there is room for.
  std::size_t capacity() const { return capacity_; }

  /// Makes room for slots below `count`, and as many again. @return capacity()
  std::size_t reserve(std::size_t count);

  /// Whether the grid was built for far fewer disks than that: its cells would hold too many each.
  bool crowdedBy(std::size_t count) const { return count > 2 * built_for_; }

  /// Puts a disk into its cell, wrapped into the width: a new grid may have left it outside.
  void add(std::uint32_t slot, double time);
  void remove(std::uint32_t slot) { grid_.remove(slot); }

  /// When the disk leaves its cell after `from`, if it does so before `until`, and by which edge.
  Crossing nextCrossing(std::uint32_t slot, double from, double until) const
  {
    const CellGrid::Cell cell = grid_.cellOf(slot);
    const BasePoint at = inGrid(slot, from);
    const auto fall = verticalIntoBase(frame_.rotation, -state_.scene().gravity);
    Crossing first{Edge::NONE, until};
    const auto leave = [&](Edge edge, double gap, double rate, double accel)
    {
      // Most edges are not reached, which takes no root to see: open at both ends, a gap that bends inwards
      // is open in between.
      const double span = first.time - from;
      if (gap > 0.0 && accel <= 0.0 && gap + (rate + 0.5 * accel * span) * span > 0.0)
        return;
      const auto time_to_edge = firstClosingTime(gap, rate, accel);
      if (time_to_edge && from + *time_to_edge < first.time)
        first = {edge, from + *time_to_edge};
    };
    if (grid_.periodic() || cell.column > 0)
      leave(Edge::LEFT, at.s() - grid_.leftEdge(cell.column), at.velocity.x(), fall.first);
    if (grid_.periodic() || cell.column + 1 < grid_.columns())
      leave(Edge::RIGHT, grid_.rightEdge(cell.column) - at.s(), -at.velocity.x(), -fall.first);
    if (cell.row > 0)
      leave(Edge::LOWER, at.n() - grid_.rowStart(cell.row), at.velocity.y(), fall.second);
    if (cell.row + 1 < grid_.rows())
      leave(Edge::UPPER, grid_.rowStart(cell.row + 1) - at.n(), -at.velocity.y(), -fall.second);
    return first;
  }

  /// Moves a disk over an edge into the next cell. @return whether it was wrapped: then it has another flight
  bool cross(std::uint32_t slot, Edge edge, double time);

  /// The cells that are next to a disk's after it has crossed an edge, and were not before.
  static CellGrid::Surroundings beyond(Edge edge);

  /// As CellGrid::visit(), around the disk's cell.
  template <typename Visit>
  void visit(std::uint32_t slot, const CellGrid::Surroundings& around, std::vector<std::uint32_t>& list,
             Visit&& visit) const
  {
    grid_.visit(grid_.cellOf(slot), around, list, visit);
  }

  /// By how many widths images may be apart that a visit finds without a shift; 0: none, shifts are exact.
  int ringShifts() const { return grid_.laps() > 0 ? 2 * grid_.laps() + 2 : 0; }

  /// An epoch ends. @param events of the run so far, crossings included
  /// @return whether another layout is cheaper by enough: then rebuild()
  bool endEpoch(std::uint64_t events, double time);

  void prefetchCellOf(std::uint32_t slot) const { grid_.prefetchCellOf(slot); }
  void prefetchAround(std::uint32_t slot) const { grid_.prefetchAround(grid_.cellOf(slot)); }

  void archive(StateArchive& state) { state(frame_, fit_, grid_, capacity_, built_for_); }

private:
  CellGrid makeGrid();
  double leastSide() const;
  CellLayout layerLayout() const;
  std::int32_t laps() const;
  CellGrid::Cell cellNow(std::uint32_t slot, double time) const;

  /// A disk in the frame of the cells, which stands still.
  BasePoint inGrid(std::uint32_t slot, double time) const
  {
    const Course now = courseAt(state_.disk(slot), time, state_.scene().gravity);
    return {frame_.into(vectorOf(now.position)), frame_.into(vectorOf(now.velocity))};
  }

  MachineState& state_;
  FrameOfBase frame_;  ///< of the cells: the base's when the grid was built
  CellFit fit_;
  CellGrid grid_;
  std::size_t capacity_;
  std::size_t built_for_;  ///< disks that had entered when the grid was built
};

}  // namespace ratchet_sieve
