#include "ratchet_sieve/geometry/room_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ratchet_sieve
{
namespace
{
/// Width of a bin in radii. In wider bins less is guaranteed to be full; narrower ones are visited less
/// often.
constexpr double BIN_WIDTH = 1.0;

/// Largest radius of the disks of one search, in units of the smallest.
constexpr double WIDEST_CLASS = 1.1;

/// In radii: cells narrower than this are not halved.
constexpr double NARROWEST = 1e-9;
}  // namespace

RoomSearch::RoomSearch(double lowest, double radius, double column_width, std::pmr::memory_resource& memory)
    : lowest_(lowest), radius_(radius), bin_width_(std::min(BIN_WIDTH * radius, column_width)), bins_(&memory)
{
}

/// @param clamped s, clamped to its bin in spite of rounding
RoomSearch::Cells& RoomSearch::cellsAt(double s, double& clamped)
{
  const double bin = std::max(0.0, std::floor(s / bin_width_));
  const double left = bin * bin_width_;
  const double right = left + bin_width_;
  clamped = std::clamp(s, left, std::nextafter(right, left));
  Cells& cells = bins_[static_cast<std::size_t>(bin)];
  if (cells.empty())
    cells.push_back({{lowest_, std::numeric_limits<double>::infinity()}, left, right});
  return cells;
}

bool RoomSearch::serves(double radius) const
{
  return radius >= radius_ && radius < WIDEST_CLASS * radius_;
}

double RoomSearch::lowestFree(double s, double radius, double lowest, const StandingDisks& standing)
{
  double clamped = s;
  Cells& cells = cellsAt(s, clamped);
  double reached = -std::numeric_limits<double>::infinity();
  for (std::size_t at = 0; at < cells.size();)
  {
    const Cell cell = cells[at];
    if (clamped < cell.left || clamped >= cell.right || cell.heights.low < reached ||
        cell.heights.high <= reached || cell.heights.high < lowest)
    {
      ++at;
      continue;
    }
    const double height =
        standing.lowestFree(s, radius, {std::max(lowest, cell.heights.low), cell.heights.high});
    // The surface cell, which every new disk raises, is not halved.
    const bool open = std::isinf(cell.heights.high);
    replace(cells, at, standing, height > cell.heights.high && !open);
    if (height <= cell.heights.high)
      return height;
    reached = cell.heights.high;
  }
  return lowest;
}

void RoomSearch::replace(Cells& cells, std::size_t at, const StandingDisks& standing, bool halved) const
{
  const Cell cell = cells[at];
  cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(at));
  const auto keep = [&](double left, double right)
  {
    for (const HeightRange& gap : standing.gaps(left, right, radius_, cell.heights))
      cells.push_back({gap, left, right});
  };
  const auto kept = static_cast<std::ptrdiff_t>(cells.size());
  if (halved && cell.right - cell.left > NARROWEST * radius_)
  {
    const double middle = 0.5 * (cell.left + cell.right);
    keep(cell.left, middle);
    keep(middle, cell.right);
  }
  else
    keep(cell.left, cell.right);
  const auto is_lower = [](const Cell& a, const Cell& b) { return a.heights.low < b.heights.low; };
  std::sort(cells.begin() + kept, cells.end(), is_lower);
  std::inplace_merge(cells.begin(), cells.begin() + kept, cells.end(), is_lower);
}

}  // namespace ratchet_sieve
