#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"
#include "search/contact_search.h"

namespace ratchet_sieve
{

/// Decides on the size of the cells: that of a vibrated layer, until another costs less for the present
/// motion of the disks. The cost is that of cell crossings and pair evaluations per second: small cells are
/// crossed often, large ones contain many disks. It is estimated from the present state, so that it is valid
/// for a dense layer and for a gas of any height.
class CellLayout
{
public:
  struct Size
  {
    double height;      ///< covered by the rows [m]
    double least_side;  ///< of a cell [m]

    void archive(StateArchive& state) { state(height, least_side); }
  };

  /// What the cost depends on.
  struct Disks
  {
    std::vector<BasePoint> points;  ///< in the frame of the cells
    double width;                   ///< of the machine [m]
    double events;                  ///< rate of those that search the adjacent cells, of all disks [1/s]
    int laps;                       ///< of a ring of one column; see CellGrid
  };

  /// The chosen size; nothing: that of a vibrated layer.
  const std::optional<Size>& chosen() const { return chosen_; }

  void countCrossings(std::uint64_t crossings) { crossings_ += crossings; }

  /// @param events of the run so far, including crossings; @param disks their number
  /// @return if a better size should be searched: the number of events in the epoch, without crossings
  std::optional<double> epochEnded(std::uint64_t events, std::size_t disks);

  /// Chooses the cheapest size, with sides of 1, 2, 4, ... times the smallest up to a single cell, if
  /// rebuilding the grid pays. @return whether it does
  bool choose(const Disks& disks, const Size& of_layer);

  void archive(StateArchive& state) { state(chosen_, events_before_, crossings_, epochs_); }

private:
  std::optional<Size> chosen_;
  std::uint64_t events_before_ = 0;  ///< at the last evaluation
  std::uint64_t crossings_ = 0;      ///< since then
  std::uint32_t epochs_ = 0;         ///< since then
};

}  // namespace ratchet_sieve
