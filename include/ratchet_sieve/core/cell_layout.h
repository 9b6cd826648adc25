#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/contact_search.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Of cells: over which height there are rows, and how small a cell may be at most.
struct CellLayout
{
  double height = 0.0;         ///< [m]
  double smallest_side = 0.0;  ///< [m]

  void archive(StateArchive& state) { state(height, smallest_side); }
};

/// What cells cost a second: crossing their edges, and looking at the disks in them. Small cells are crossed
/// often, large ones hold many disks. Measured on the disks as they are now, so that it is right for a dense
/// layer as for a gas that fills any height.
class LayoutCosts
{
public:
  /// @param points of all disks, in the frame of the cells; @param width of the machine [m]
  /// @param events that search all cells around, of all disks [1/s]
  /// @param laps of a ring of one column; see CellGrid
  LayoutCosts(const std::vector<BasePoint>& points, double width, double events, int laps);

  /// In looks at a disk a second.
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
  /// @return where it is time to look for better cells: the events of an epoch, beside crossings
  std::optional<double> epochEnded(std::uint64_t events, std::size_t disks);

  /// Takes the cheapest cells, if they are cheaper by enough to be laid. @return whether they are
  bool choose(const LayoutCosts& costs, const CellLayout& for_layer, double least_side);

  void archive(StateArchive& state) { state(layout_, events_before_, crossings_, epochs_); }

private:
  std::optional<CellLayout> layout_;
  std::uint64_t events_before_ = 0;  ///< when it was last looked
  std::uint64_t crossings_ = 0;      ///< since then
  std::uint32_t epochs_ = 0;         ///< since then
};

}  // namespace ratchet_sieve
