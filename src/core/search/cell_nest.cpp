#include "search/cell_nest.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ratchet_sieve
{
namespace
{
std::int32_t at(const std::vector<std::int32_t>& extent, std::int32_t rows)
{
  return rows < static_cast<std::int32_t>(extent.size()) ? extent[static_cast<std::size_t>(rows)] : -1;
}
}  // namespace

CellNest::CellNest(const CellShape& shape, SizeLevels levels, double margin)
    : levels_(std::move(levels)), margin_(margin)
{
  larger_.resize(levels_.count() - 1);
  build(shape);
  for (Level& level : larger_)
  {
    const auto rows = static_cast<std::size_t>((shape_.rows - 1) >> level.shift) + 1;
    level.blocks = CellBlocks(level.columns * rows);
    level.smallest_radius = levels_.largest();
  }
}

/// What follows from the levels and the grid.
void CellNest::build(const CellShape& shape)
{
  shape_ = shape;
  for (std::size_t k = 0; k < larger_.size(); ++k)
  {
    larger_[k].shift = std::max(1, std::ilogb(levels_.diameters[k + 1] / levels_.diameters[0]));
    larger_[k].columns = static_cast<std::size_t>((shape_.columns - 1) >> larger_[k].shift) + 1;
  }
  const std::size_t count = levels_.count();
  extents_.resize(count * count);
  reaches_.assign(count, 0);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < count; ++b)
    {
      Extent& extent = extents_[a * count + b];
      extent =
          extentOf(0.5 * (levels_.diameters[std::min(a, b)] + levels_.diameters[std::max(a, b)]) + margin_);
      reaches_[a] = std::max(reaches_[a], extent[0]);
    }
}

/// The cells that may contain a point within `reach` of a point of the cell in their middle.
CellNest::Extent CellNest::extentOf(double reach) const
{
  const auto rows = static_cast<std::int32_t>(std::ceil(reach / shape_.side_n));
  Extent extent;
  for (std::int32_t row = 0; row <= rows; ++row)
  {
    const double away = std::max(0, row - 1) * shape_.side_n;
    const double along = std::sqrt(std::max(0.0, reach * reach - away * away));
    extent.push_back(std::max(1, static_cast<std::int32_t>(std::ceil(along / shape_.side_s))));
  }
  return extent;
}

/// The cells whose points are all within the radius of any point of the cell in their middle.
CellNest::Extent CellNest::coveredBy(double radius) const
{
  Extent extent;
  const double within = radius - margin_;
  for (std::int32_t row = 0;; ++row)
  {
    const double away = (row + 1) * shape_.side_n;
    if (away >= within)
      return extent;
    const double columns = std::floor(std::sqrt(within * within - away * away) / shape_.side_s) - 1.0;
    if (columns < 0.0)
      return extent;
    extent.push_back(static_cast<std::int32_t>(columns));
  }
}

void CellNest::add(std::uint8_t level, std::int32_t column, std::int32_t row, std::uint32_t slot,
                   double radius)
{
  Level& of = larger_[level - 1];
  of.blocks.add(bucket(level, column, row), slot);
  ++of.disks;
  if (radius < of.smallest_radius)
  {
    of.smallest_radius = radius;
    of.covered = coveredBy(radius);
  }
}

void CellNest::remove(std::uint8_t level, std::int32_t column, std::int32_t row, std::uint32_t slot)
{
  Level& of = larger_[level - 1];
  of.blocks.remove(bucket(level, column, row), slot);
  --of.disks;
}

std::size_t CellNest::collect(const Place& place, const CellBlocks& smallest,
                              std::vector<std::uint32_t>& list) const
{
  static const Extent NOTHING;
  std::size_t count = 0;
  for (std::size_t level = 0; level < levels_.count(); ++level)
  {
    const Extent& covered = level < place.level ? larger_[place.level - 1].covered : NOTHING;
    Buckets buckets{&smallest, 0, static_cast<std::size_t>(shape_.columns)};
    if (level > 0)
    {
      const Level& of = larger_[level - 1];
      if (of.disks == 0)
        continue;
      buckets = {&of.blocks, of.shift, of.columns};
    }
    count = collect(place, buckets, extent(place.level, level), covered, list, count);
  }
  return count;
}

/// Of the row of buckets over the rows `first` to `last` of fine cells.
CellNest::Columns CellNest::columnsOf(const Place& place, std::int32_t first, std::int32_t last,
                                      const Extent& extent, const Extent& covered) const
{
  const auto most = static_cast<std::int32_t>(extent.size()) - 1;
  const std::int32_t last_column = shape_.columns - 1;
  const std::int32_t below = place.row - first;
  const std::int32_t above = last - place.row;
  const std::int32_t farthest = std::max(below, above);
  const std::int32_t outer = at(extent, std::max({0, -below, -above}));
  Columns columns{{place.column - outer, place.column + outer}, {0, -1}};
  switch (place.entered)
  {
    case CellEdge::NONE:
      if (const std::int32_t inner = at(covered, farthest);
          inner >= 0 && isBounded(place) && first > 0 && last + 1 < shape_.rows)
      {
        columns.skipped = {place.column - inner, place.column + inner};
        if (!shape_.periodic)
          columns.skipped = {std::max(columns.skipped.first, 1),
                             std::min(columns.skipped.last, last_column - 1)};
      }
      break;
    case CellEdge::LEFT:
      columns.read.last = place.column - at(extent, std::min(farthest, most));
      break;
    case CellEdge::RIGHT:
      columns.read.first = place.column + at(extent, std::min(farthest, most));
      break;
    case CellEdge::LOWER:
    case CellEdge::UPPER:
    {
      const std::int32_t inner = at(extent, (place.entered == CellEdge::UPPER ? above : below) + 1);
      columns.skipped = {place.column - inner, place.column + inner};
      break;
    }
  }
  columns.read = {std::max(columns.read.first, 0), std::min(columns.read.last, last_column)};
  return columns;
}

/// Whether the disk's cell is none of the outermost, which are without end: nothing covers them.
bool CellNest::isBounded(const Place& place) const
{
  return place.row > 0 && place.row + 1 < shape_.rows &&
         (shape_.periodic || (place.column > 0 && place.column < shape_.columns - 1));
}

/// Row by row of the buckets. @param covered cells that need not be read
std::size_t CellNest::collect(const Place& place, const Buckets& buckets, const Extent& extent,
                              const Extent& covered, std::vector<std::uint32_t>& list,
                              std::size_t count) const
{
  const auto most = static_cast<std::int32_t>(extent.size()) - 1;
  const std::int32_t lowest = place.entered == CellEdge::UPPER ? place.row : std::max(place.row - most, 0);
  const std::int32_t highest =
      place.entered == CellEdge::LOWER ? place.row : std::min(place.row + most, shape_.rows - 1);
  const std::int32_t size = 1 << buckets.shift;
  for (std::int32_t row = lowest >> buckets.shift; row <= highest >> buckets.shift; ++row)
  {
    const std::int32_t first = row << buckets.shift;
    const auto [span, skipped] = columnsOf(place, first, first + size - 1, extent, covered);
    if (span.first > span.last)
      continue;
    const auto read = [&](std::int32_t from, std::int32_t to)
    {
      const std::size_t start = static_cast<std::size_t>(row) * buckets.columns;
      if (from <= to)
        count = buckets.blocks->collect(start + static_cast<std::size_t>(from),
                                        static_cast<std::size_t>(to - from) + 1, 1, 0, list, count);
    };
    const Span all{span.first >> buckets.shift, span.last >> buckets.shift};
    // Buckets that are skipped as a whole; if there are none, those after the last.
    Span whole{(std::max(skipped.first, 0) + size - 1) >> buckets.shift,
               ((std::max(skipped.last, -1) + 1) >> buckets.shift) - 1};
    if (skipped.first > skipped.last || whole.first > whole.last)
      whole = {all.last + 1, all.last};
    read(all.first, std::min(all.last, whole.first - 1));
    read(std::max(all.first, whole.last + 1), all.last);
  }
  return count;
}

void CellNest::archive(StateArchive& state, const CellShape& shape)
{
  state(levels_, margin_, larger_);
  if (!state.restoring() || empty())
    return;
  build(shape);
  for (Level& level : larger_)
    level.covered = coveredBy(level.smallest_radius);
}

}  // namespace ratchet_sieve
