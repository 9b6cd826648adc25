#include "ratchet_sieve/core/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// More cells than this per disk would be empty: memory and crossings for nothing.
constexpr double MAX_CELLS_PER_DISK = 4.0;
constexpr double MIN_CELLS = 64.0;
}  // namespace

CellGrid::CellGrid(double width, double height, double smallest_side, std::size_t count, bool periodic)
    : periodic_(periodic)
{
  const double limit = std::max(MIN_CELLS, MAX_CELLS_PER_DISK * static_cast<double>(count));
  const double side = std::max(smallest_side, std::sqrt(width * height / limit));
  columns_ = static_cast<std::int32_t>(std::clamp(std::floor(width / side), 1.0, limit));
  rows_ = static_cast<std::int32_t>(std::clamp(std::floor(height / side), 1.0, limit));
  side_s_ = width / columns_;
  side_n_ = std::max(side, height / rows_);
  heads_.assign(static_cast<std::size_t>(columns_) * rows_, NONE);
  resize(count);
}

void CellGrid::resize(std::size_t count)
{
  links_.resize(count);
  cells_.resize(count);
}

void CellGrid::add(std::uint32_t id, Cell cell)
{
  cells_[id] = cell;
  std::uint32_t& head = heads_[index(cell)];
  links_[id] = {head, NONE};
  if (head != NONE)
    links_[head].previous = id;
  head = id;
}

void CellGrid::remove(std::uint32_t id)
{
  const Link link = links_[id];
  if (link.next != NONE)
    links_[link.next].previous = link.previous;
  if (link.previous != NONE)
    links_[link.previous].next = link.next;
  else
    heads_[index(cells_[id])] = link.next;
}

CellGrid::Cell CellGrid::cellAt(double s, double n) const
{
  const auto clamped = [](double position, std::int32_t count)
  { return static_cast<std::int32_t>(std::clamp(std::floor(position), 0.0, count - 1.0)); };
  return {clamped(s / side_s_, columns_), clamped(n / side_n_, rows_)};
}

}  // namespace ratchet_sieve
