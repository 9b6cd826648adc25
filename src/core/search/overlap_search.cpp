#include "search/overlap_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ratchet_sieve
{
namespace
{
/// Columns are wider than the largest disk by this factor, because move() leaves a disk in its column.
constexpr double COLUMN_MARGIN = 1.1;

/// Number of roundings in a disk's position and in its differences to others.
constexpr double ROUNDINGS = 4.0;
}  // namespace

OverlapSearch::OverlapSearch(double width, double largest_diameter, bool periodic)
    : width_(width),
      periodic_(periodic),
      columns_(
          static_cast<std::size_t>(std::max(1.0, std::floor(width / (COLUMN_MARGIN * largest_diameter))))),
      columns_per_length_(static_cast<double>(columns_) / width),
      last_column_(static_cast<double>(columns_ - 1)),
      slack_(ROUNDINGS * std::numeric_limits<float>::epsilon() * width),
      starts_(columns_ + 3)
{
}

void OverlapSearch::begin(std::size_t count)
{
  placed_.clear();
  row_of_.resize(count);
}

void OverlapSearch::sort()
{
  disks_ = static_cast<std::uint32_t>(placed_.size());
  // Column c of the base has index c + 1; the first and the last column are images.
  std::fill(starts_.begin(), starts_.end(), 0);
  for (const Placed& disk : placed_)
    ++starts_[disk.column + 2];
  const std::uint32_t in_first = starts_[2];
  const std::uint32_t in_last = starts_[columns_ + 1];
  first_ = periodic_ ? in_last : 0;
  starts_[1] = first_;
  std::partial_sum(starts_.begin() + 1, starts_.end(), starts_.begin() + 1);
  const std::uint32_t rows = starts_[columns_ + 1] + (periodic_ ? in_first : 0);
  starts_[columns_ + 2] = rows;
  const std::size_t room = rows + OverlapRows::MOST_LANES + 1;
  if (rows_.s.size() < room)
  {
    for (std::vector<float>* values : {&rows_.s, &rows_.n, &rows_.radius})
      values->resize(room);
    slots_.resize(room);
  }
  // starts_ is used as the next free place of each column, and restored afterwards.
  for (const Placed& disk : placed_)
  {
    const std::uint32_t row = starts_[disk.column + 1]++;
    row_of_[disk.slot] = row;
    put(row, disk, disk.s);
  }
  std::copy_backward(starts_.begin() + 1, starts_.begin() + 1 + static_cast<std::ptrdiff_t>(columns_),
                     starts_.begin() + 2 + static_cast<std::ptrdiff_t>(columns_));
  starts_[1] = first_;
  if (!periodic_)
    return;
  const auto width = static_cast<float>(width_);
  const auto image = [&](std::uint32_t row, std::uint32_t of, float shift) {
    put(row, {slots_[of], 0, 0.0F, rows_.n[of], rows_.radius[of]}, rows_.s[of] + shift);
  };
  for (std::uint32_t k = 0; k < in_last; ++k)
    image(k, k + disks_, -width);
  for (std::uint32_t k = 0; k < in_first; ++k)
    image(first_ + disks_ + k, first_ + k, width);
}

void OverlapSearch::put(std::uint32_t row, const Placed& disk, float s)
{
  rows_.s[row] = s;
  rows_.n[row] = disk.n;
  rows_.radius[row] = disk.radius;
  slots_[row] = disk.slot;
}

std::uint32_t OverlapSearch::putGuest(const OverlapDisk& disk)
{
  const std::size_t row = rows_.s.size() - 1;
  rows_.s[row] = disk.s;
  rows_.n[row] = disk.n;
  rows_.radius[row] = disk.radius;
  return static_cast<std::uint32_t>(row);
}

void OverlapSearch::move(std::uint32_t slot, double s, double n)
{
  const std::uint32_t row = row_of_[slot];
  const auto place = [this, n](std::uint32_t at, double along)
  {
    rows_.s[at] = static_cast<float>(along);
    rows_.n[at] = static_cast<float>(n);
  };
  place(row, s);
  if (periodic_ && row >= disks_)
    place(row - disks_, s - width_);
  if (periodic_ && row + disks_ < starts_[columns_ + 2])
    place(row + disks_, s + width_);
}

}  // namespace ratchet_sieve
