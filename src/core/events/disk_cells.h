#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "search/cell_grid.h"
#include "search/cell_layout.h"
#include "search/contact_search.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// The cell list: the cell of each active disk, and the time at which the disk leaves it. Disks in cells that
/// do not touch are further apart than the largest diameter. If sizes are wide, cells suit the small disks,
/// and the large ones are nested (CellNest).
///
/// The columns of a periodic grid form a ring. While the base does not turn, a disk is wrapped when it
/// crosses the ends of the ring. While the base turns, a disk is wrapped at the ends of the base. The grid
/// then keeps an image of it as long as the ends of base and grid differ, and searches all rows at its seam,
/// where the images rise or sink by several rows.
///
/// The cells are sized for a vibrated layer. In a dilute, fast system most events would be cell crossings. So
/// at the end of an epoch the grid is rebuilt if another CellLayout is cheaper for the present disks.
class DiskCells
{
public:
  using Edge = CellEdge;

  struct Crossing
  {
    Edge edge = Edge::NONE;
    double time = 0.0;  ///< if there is no edge: not before this time
  };

  /// @param state outlives this; its disks are in no cell before rebuild() or add()
  explicit DiskCells(SystemState& state);

  /// Builds a grid on the base at `time`, with all disks at slots below `count`.
  void rebuild(std::size_t count, double time);

  /// Number of slots with memory.
  std::size_t capacity() const { return capacity_; }

  /// Allocates memory for slots below `count`, doubled. @return capacity()
  std::size_t reserve(std::size_t count);

  /// Whether the grid was built for far fewer disks: its cells would contain too many.
  bool crowdedBy(std::size_t count) const { return count > 2 * built_for_; }

  /// Adds a disk to its cell, wrapped into the width, because a new grid may have left it outside.
  /// @param buffer as in SystemState::collided(), here and below. Several threads may move disks between
  /// cells of different columns at the same time.
  void add(std::uint32_t slot, double time, ThreadBuffer* buffer = nullptr);
  void remove(std::uint32_t slot) { grid_.remove(slot); }
  const CellGrid& grid() const { return grid_; }

  /// Moves a disk to the cell of its new image.
  void replace(std::uint32_t slot, double time, ThreadBuffer* buffer)
  {
    remove(slot);
    add(slot, time, buffer);
  }

  /// When the disk next leaves its cell after `start` and before `until`, and by which edge.
  Crossing nextCrossing(std::uint32_t slot, const Kinematics& start, double until) const
  {
    const double from = start.time;
    const CellGrid::Cell cell = grid_.cellOf(slot);
    const BasePoint at = inGrid(slot, start);
    const auto fall = verticalIntoBase(frame_.rotation, -state_.scene().gravity);
    Crossing first{Edge::NONE, until};
    const auto leave = [&](Edge edge, double gap, double rate, double accel) __attribute__((always_inline))
    {
      // Most edges are not reached, which needs no square root to decide: if the gap is positive at both ends
      // of the span and concave, it is positive in between.
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

  /// Whether a disk is clear of the base anywhere in its cell.
  bool aboveBase(std::uint32_t slot) const { return grid_.rowStart(grid_.cellOf(slot).row) >= above_base_; }

  /// Moves a disk over an edge into the next cell. @return whether it was wrapped, which changes its flight
  bool cross(std::uint32_t slot, Edge edge, double time, ThreadBuffer* buffer);

  /// To be called after crossings, with their number.
  void countCrossings(std::uint64_t crossings) { layout_.countCrossings(crossings); }

  /// The cells of the disks, without what decides on the grid.
  struct Snapshot
  {
    std::vector<std::int32_t> images;
    std::optional<CellGrid> grid;
  };
  void copyTo(Snapshot& snapshot)
  {
    snapshot.images = images_;
    snapshot.grid = grid_;
  }
  void restore(const Snapshot& snapshot)
  {
    images_ = snapshot.images;
    grid_ = *snapshot.grid;
  }

  /// To be called before several threads move disks.
  void shareAmongThreads() { grid_.reserveOverflow(); }

  /// Whether disks see at most those of the next column to either side.
  bool seesNextColumnOnly() const { return grid_.levels().count() == 0 && grid_.columns() > 1; }

  /// Per slot, while a periodic base turns: the image of a disk in the grid, in widths to the right of the
  /// disk. Null if this disk and all that it sees are in the grid themselves.
  const std::int32_t* images(std::uint32_t slot) const
  {
    return lattice_turns_ && (grid_.levels().count() > 0 || grid_.seesOpenSeam(slot)) ? images_.data()
                                                                                      : nullptr;
  }

  /// Largest difference of images, in widths, that a visit finds without a shift; 0: none, shifts are exact.
  int ringShifts() const { return grid_.laps() > 0 ? 2 * grid_.laps() + 2 : 0; }

  /// To be called at the end of an epoch. @param events of the run so far, including crossings
  /// @return whether another layout is sufficiently cheaper: then call rebuild()
  bool endEpoch(std::uint64_t events, double time);

  void archive(StateArchive& state);

private:
  double latticeMargin() const;
  CellGrid makeGrid();
  void openSeam();

  /// What the cells have to suit, of the present disks.
  struct Sizes
  {
    SizeLevels levels;
    double squares;     ///< sum of the squared diameters, as the layer's height takes them [m^2]
    double least_side;  ///< smallest allowed side of a cell [m]
  };
  Sizes sizes() const;
  CellLayout::Size sizeForLayer(const Sizes& sizes) const;
  std::int32_t laps() const;
  CellGrid::Cell cellNow(std::uint32_t slot, double time) const;

  /// The position of a disk, or of its image in the grid, in the fixed frame of the cells.
  [[gnu::always_inline]] BasePoint inGrid(std::uint32_t slot, const Kinematics& now) const
  {
    BasePoint point{frame_.into(vectorOf(now.position)), frame_.into(vectorOf(now.velocity))};
    point.position.y() += state_.shape().depth();
    if (lattice_turns_)
      point.position.x() += images_[slot] * state_.shape().width();
    return point;
  }
  BasePoint inGrid(std::uint32_t slot, double time) const { return inGrid(slot, state_.flown(slot, time)); }

  SystemState& state_;
  FrameOfBase frame_;        ///< of the cells: see makeGrid()
  double above_base_ = 0.0;  ///< from this height over its lowest corner on, no disk reaches the base [m]
  CellLayout layout_;
  std::size_t capacity_;
  std::size_t built_for_;             ///< number of disks when the grid was built
  bool lattice_turns_ = false;        ///< whether the grid was built on a periodic base that turns
  std::vector<std::int32_t> images_;  ///< see images()
  CellGrid grid_;
};

}  // namespace ratchet_sieve
