#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"
#include "search/contact_search.h"

namespace ratchet_sieve
{

/// The height covered by rows, and the smallest allowed side of a cell.
struct CellLayout
{
  double height = 0.0;         ///< [m]
  double smallest_side = 0.0;  ///< [m]

  void archive(StateArchive& state) { state(height, smallest_side); }
};

/// The cost of a cell layout per second: cell crossings and pair evaluations. Small cells are crossed often;
/// large cells contain many disks. Estimated from the present state, so that it is valid for a dense layer
/// and for a gas of any height.
class LayoutCosts
{
public:
  /// @param points of all disks, in the frame of the cells; @param width of the machine [m]
  /// @param events rate of events that search the adjacent cells, of all disks [1/s]
  /// @param laps of a ring of one column; see CellGrid
  LayoutCosts(const std::vector<BasePoint>& points, double width, double events, int laps);

  /// In pair evaluations per second.
  double of(const CellLayout& layout) const;

  /// The cheapest layout among sides of 1, 2, 4, ... times the smallest, up to a single cell.
  CellLayout cheapest(double least_side) const;

private:
  const std::vector<BasePoint>& points_;
  double width_;
  double events_;
  int laps_;
  double top_ = 0.0;  ///< height below which nearly all disks are [m]
};

/// Monitors whether the cells suit the motion of the disks. Starts with the layout of a vibrated layer, until
/// another is cheaper.
class CellFit
{
public:
  /// The chosen layout; nothing: the one of a vibrated layer.
  const std::optional<CellLayout>& layout() const { return layout_; }

  /// Counts cell crossings.
  void crossed(std::uint64_t crossings) { crossings_ += crossings; }

  /// @param events of the run so far, including crossings; @param disks their number
  /// @return if a better layout should be searched: the number of events in the epoch, without crossings
  std::optional<double> epochEnded(std::uint64_t events, std::size_t disks);

  /// Adopts the cheapest layout if rebuilding the grid pays. @return whether it does
  bool choose(const LayoutCosts& costs, const CellLayout& for_layer, double least_side);

  void archive(StateArchive& state) { state(layout_, events_before_, crossings_, epochs_); }

private:
  std::optional<CellLayout> layout_;
  std::uint64_t events_before_ = 0;  ///< at the last evaluation
  std::uint64_t crossings_ = 0;      ///< since then
  std::uint32_t epochs_ = 0;         ///< since then
};

}  // namespace ratchet_sieve
