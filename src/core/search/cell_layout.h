#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"
#include "search/contact_search.h"

namespace ratchet_sieve
{

/// Of cells: over which height there are rows, and how small a cell may be at most.
struct CellLayout
{
  double height = 0.0;         ///< [m]
  double smallest_side = 0.0;  ///< [m]

  void archive(StateArchive& state) { state(height, smallest_side); }
};

/// The cost of a layout per second: crossings of cell edges, and pairs evaluated. Small cells are crossed
/// often, large ones hold many disks. Estimated from the present state, so that it holds for a dense layer as
/// for a gas that fills any height.
class LayoutCosts
{
public:
  /// @param points of all disks, in the frame of the cells; @param width of the machine [m]
  /// @param events that search all cells around, of all disks [1/s]
  /// @param laps of a ring of one column; see CellGrid
  LayoutCosts(const std::vector<BasePoint>& points, double width, double events, int laps);

  /// In pair evaluations per second.
  double of(const CellLayout& layout) const;

  /// The best of cells with sides of 1, 2, 4, ... times the least, up to one cell for all.
  CellLayout cheapest(double least_side) const;

private:
  const std::vector<BasePoint>& points_;
  double width_;
  double events_;
  int laps_;
  double top_ = 0.0;  ///< under which nearly all disks are [m]
};

/// Watches whether cells fit what the disks do: those of a shaken layer, until others are cheaper.
class CellFit
{
public:
  /// The layout that was chosen; nothing: the shaken layer's.
  const std::optional<CellLayout>& layout() const { return layout_; }

  /// A disk has crossed an edge.
  void crossed() { ++crossings_; }

  /// @param events of the run so far, crossings included; @param disks that there are
  /// @return where a better layout is to be searched: the events of an epoch, without crossings
  std::optional<double> epochEnded(std::uint64_t events, std::size_t disks);

  /// Takes the cheapest layout, if rebuilding the grid pays. @return whether it does
  bool choose(const LayoutCosts& costs, const CellLayout& for_layer, double least_side);

  void archive(StateArchive& state) { state(layout_, events_before_, crossings_, epochs_); }

private:
  std::optional<CellLayout> layout_;
  std::uint64_t events_before_ = 0;  ///< at the last evaluation
  std::uint64_t crossings_ = 0;      ///< since then
  std::uint32_t epochs_ = 0;         ///< since then
};

}  // namespace ratchet_sieve
