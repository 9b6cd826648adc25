#include "search/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// With more cells per disk, most would be empty and cost memory and crossings.
constexpr double MAX_CELLS_PER_DISK = 1.5;
constexpr double MIN_CELLS = 64.0;
}  // namespace

CellShape::CellShape(double width, double height, double smallest_side, std::size_t count)
{
  const double limit = std::max(MIN_CELLS, MAX_CELLS_PER_DISK * static_cast<double>(count));
  const double side = std::max(smallest_side, std::sqrt(width * height / limit));
  columns = static_cast<std::int32_t>(std::clamp(std::floor(width / side), 1.0, limit));
  rows = static_cast<std::int32_t>(std::clamp(std::floor(height / side), 1.0, limit));
  side_s = width / columns;
  side_n = side;
}

CellGrid::CellGrid(double width, double height, double smallest_side, std::size_t count, bool periodic,
                   std::int32_t laps)
    : CellGrid(CellShape(width, height, smallest_side, count), count, periodic, laps)
{
}

CellGrid::CellGrid(const CellShape& shape, std::size_t count, bool periodic, std::int32_t laps)
    : periodic_(periodic),
      laps_(periodic && shape.columns == 1 ? laps : 0),
      columns_(shape.columns),
      rows_(shape.rows),
      side_s_(shape.side_s),
      side_n_(shape.side_n)
{
  blocks_.resize(static_cast<std::size_t>(columns_) * rows_);
  resize(count);
}

void CellGrid::resize(std::size_t count)
{
  cells_.resize(count);
}

void CellGrid::add(std::uint32_t slot, Cell cell)
{
  cells_[slot] = cell;
  const std::size_t at = index(cell);
  if (blocks_[at].count == Block::CAPACITY)
    pushFullBlock(at);
  Block& block = blocks_[at];
  block.slots[block.count++] = slot;
}

void CellGrid::remove(std::uint32_t slot)
{
  const std::size_t at = index(cells_[slot]);
  if (blocks_[at].count == 0)
    popFullBlock(at);
  Block& first = blocks_[at];
  const std::uint32_t last = first.slots[--first.count];
  if (last == slot)
    return;
  // The last disk takes the entry of the removed one, so that all blocks but the first stay full.
  for (Block* block = &first;; block = &full_[block->next])
  {
    const auto end = block->slots.begin() + block->count;
    const auto hole = std::find(block->slots.begin(), end, slot);
    if (hole == end)
      continue;
    *hole = last;
    return;
  }
}

/// Moves the cell's full block to the overflow list.
void CellGrid::pushFullBlock(std::size_t cell)
{
  std::size_t entry = full_.size();
  if (free_.empty())
    full_.emplace_back();
  else
  {
    entry = free_.back();
    free_.pop_back();
  }
  full_[entry] = blocks_[cell];
  blocks_[cell] = Block();
  blocks_[cell].next = static_cast<std::uint32_t>(entry);
}

/// An empty cell takes its last full block back from the overflow list.
void CellGrid::popFullBlock(std::size_t cell)
{
  const std::uint32_t entry = blocks_[cell].next;
  blocks_[cell] = full_[entry];
  free_.push_back(entry);
}

bool CellGrid::holds(std::uint32_t slot) const
{
  if (slot >= cells_.size() || index(cells_[slot]) >= blocks_.size())
    return false;
  std::vector<std::uint32_t> list;
  const std::size_t count = collect(index(cells_[slot]), list, 0);
  return std::find(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count), slot) !=
         list.begin() + static_cast<std::ptrdiff_t>(count);
}

/// Whether every disk is in at most one cell, the cell recorded for it, and every block in one list.
bool CellGrid::isLegal() const
{
  const bool of_a_size = columns_ > 0 && rows_ > 0 && laps_ >= 0 && (laps_ == 0 || columns_ == 1) &&
                         side_s_ > 0.0 && side_n_ > 0.0 && std::isfinite(side_s_) && std::isfinite(side_n_);
  if (!of_a_size || blocks_.size() != static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_))
    return false;
  std::vector<std::uint8_t> seen(cells_.size());
  std::vector<std::uint8_t> used(full_.size());
  for (const std::uint32_t entry : free_)
    if (entry >= full_.size() || used[entry]++ != 0)
      return false;
  for (std::size_t cell = 0; cell < blocks_.size(); ++cell)
    if (!isLegal(cell, seen, used))
      return false;
  return true;
}

/// @param seen disks, @param used full blocks so far; those of this cell are added
bool CellGrid::isLegal(std::size_t cell, std::vector<std::uint8_t>& seen,
                       std::vector<std::uint8_t>& used) const
{
  for (const Block* block = &blocks_[cell];; block = &full_[block->next])
  {
    if (block->count > Block::CAPACITY || (block != &blocks_[cell] && block->count < Block::CAPACITY))
      return false;
    for (std::uint32_t k = 0; k < block->count; ++k)
    {
      const std::uint32_t slot = block->slots[k];
      if (slot >= cells_.size() || seen[slot]++ != 0)
        return false;
      const Cell at = cells_[slot];
      if (at.column < 0 || at.column >= columns_ || at.row < 0 || at.row >= rows_ || index(at) != cell)
        return false;
    }
    if (block->next == NONE)
      return true;
    if (block->next >= full_.size() || used[block->next]++ != 0)
      return false;
  }
}

CellGrid::Cell CellGrid::cellAt(double s, double n) const
{
  const auto clamped = [](double position, std::int32_t count)
  { return static_cast<std::int32_t>(std::clamp(std::floor(position), 0.0, count - 1.0)); };
  return {clamped(s / side_s_, columns_), clamped(n / side_n_, rows_)};
}

}  // namespace ratchet_sieve
