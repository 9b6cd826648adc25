#include "ratchet_sieve/geometry/overlap_search.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

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

/// Number of rows that are tested at a time. Sixteen with AVX-512 take longer: see docs/performance.md.
constexpr std::uint32_t LANES = 4;

/// Bit k: whether the row overlaps the k-th of four from `at` on.
unsigned overlapsOfFour(const float* s, const float* n, const float* radius, std::uint32_t row,
                        std::uint32_t at)
{
#if defined(__SSE2__)
  const __m128 ds = _mm_sub_ps(_mm_loadu_ps(s + at), _mm_set1_ps(s[row]));
  const __m128 dn = _mm_sub_ps(_mm_loadu_ps(n + at), _mm_set1_ps(n[row]));
  const __m128 reach = _mm_add_ps(_mm_loadu_ps(radius + at), _mm_set1_ps(radius[row]));
  const __m128 distance_squared = _mm_add_ps(_mm_mul_ps(ds, ds), _mm_mul_ps(dn, dn));
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(distance_squared, _mm_mul_ps(reach, reach))));
#else
  unsigned found = 0;
  for (unsigned k = 0; k < LANES; ++k)
  {
    const float ds = s[at + k] - s[row];
    const float dn = n[at + k] - n[row];
    const float reach = radius[at + k] + radius[row];
    found |= (ds * ds + dn * dn < reach * reach ? 1U : 0U) << k;
  }
  return found;
#endif
}
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
  const std::size_t room = rows + LANES + 1;
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

std::size_t OverlapSearch::hitsIn(std::uint32_t row, std::uint32_t begin, std::uint32_t end)
{
  if (hits_.size() < end - begin + LANES)
    hits_.resize(end - begin + LANES);
  std::uint32_t* const hits = hits_.data();
  std::size_t count = 0;
  for (std::uint32_t at = begin; at < end; at += LANES)
    for (unsigned found = overlapsOfFour(rows_.s.data(), rows_.n.data(), rows_.radius.data(), row, at);
         found != 0; found &= found - 1)
    {
      const std::uint32_t other = at + static_cast<std::uint32_t>(__builtin_ctz(found));
      hits[count] = other;
      count += other < end && other != row ? 1 : 0;
    }
  return count;
}

void OverlapSearch::put(std::uint32_t row, const Placed& disk, float s)
{
  rows_.s[row] = s;
  rows_.n[row] = disk.n;
  rows_.radius[row] = disk.radius;
  slots_[row] = disk.slot;
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

void OverlapLevels::sort()
{
  if (placed_.size() > 2 * chosen_for_ || searches_.empty())
    chooseLevels();
  for (OverlapSearch& search : searches_)
    search.begin(level_of_.size());
  for (const Placed& disk : placed_)
  {
    level_of_[disk.slot] = levels_.of(disk.radius);
    searches_[level_of_[disk.slot]].place(disk.slot, disk.s, disk.n, disk.radius);
  }
  for (OverlapSearch& search : searches_)
    search.sort();
}

void OverlapLevels::chooseLevels()
{
  std::vector<double> radii;
  for (const Placed& disk : placed_)
    radii.push_back(disk.radius);
  levels_ = cheapestLevels(radii, largest_diameter_);
  chosen_for_ = placed_.size();
  searches_.clear();
  for (const double diameter : levels_.diameters)
    searches_.emplace_back(width_, diameter, periodic_);
}

}  // namespace ratchet_sieve
