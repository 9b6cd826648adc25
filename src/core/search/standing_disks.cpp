#include "search/standing_disks.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// Poured disks keep this distance, as a fraction of the sum of their radii, so that rounding causes no
/// overlap.
constexpr double SPACING = 1e-6;

/// Radii are reduced by this fraction when a whole interval is tested, so that rounding excludes no position
/// that is free.
constexpr double SURE = 1e-7;

/// Range of heights searched at once, in units of the largest contact distance.
constexpr double WINDOW = 1.0;

bool isLower(const PlacedDisk& a, const PlacedDisk& b)
{
  return a.n < b.n;
}

bool startsLower(const HeightRange& a, const HeightRange& b)
{
  return a.low < b.low;
}
}  // namespace

StandingDisks::StandingDisks(double width, bool periodic, double largest_diameter)
    : width_(width), periodic_(periodic), largest_radius_(0.5 * largest_diameter)
{
  // With fewer than three columns on a ring, the neighbours on both sides would be the same column.
  const double count = std::floor(width_ / std::max(largest_diameter, width_ * 1e-6));
  columns_.resize(count < 3.0 ? 1 : static_cast<std::size_t>(count));
  column_width_ = width_ / static_cast<double>(columns_.size());
}

std::size_t StandingDisks::columnAt(double s) const
{
  const double column = std::floor(s / column_width_);
  return static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(columns_.size() - 1)));
}

/// A single disk is usually near the top and is inserted in order; many disks added before the first search
/// are sorted once.
void StandingDisks::add(const PlacedDisk& disk)
{
  Column& column = columns_[columnAt(disk.s)];
  if (column.sorted < column.disks.size() || column.sorted == 0)
  {
    column.disks.push_back(disk);
    return;
  }
  column.disks.insert(std::upper_bound(column.disks.begin(), column.disks.end(), disk, isLower), disk);
  ++column.sorted;
}

void StandingDisks::sort(const Column& column)
{
  if (column.sorted == column.disks.size())
    return;
  std::sort(column.disks.begin(), column.disks.end(), isLower);
  column.sorted = column.disks.size();
}

/// Calls visit(disk, shift) for the disks in these columns and their neighbours with centres in this range of
/// heights, and for each of their images, `shift` to the right [m].
template <typename Visit>
void StandingDisks::visitColumns(std::size_t first, std::size_t last, HeightRange heights,
                                 Visit&& visit) const
{
  const auto count = static_cast<long>(columns_.size());
  const long beside = count > 1 ? 1 : 0;
  for (long at = static_cast<long>(first) - beside; at <= static_cast<long>(last) + beside; ++at)
  {
    if (!periodic_ && (at < 0 || at >= count))
      continue;
    const Column& column = columns_[static_cast<std::size_t>((at + count) % count)];
    sort(column);
    auto disk = std::lower_bound(column.disks.begin(), column.disks.end(), PlacedDisk{0.0, heights.low, 0.0},
                                 isLower);
    for (; disk != column.disks.end() && disk->n <= heights.high; ++disk)
      for (const double image : {-width_, 0.0, width_})
        if (periodic_ || image == 0.0)
          visit(*disk, image);
  }
}

double StandingDisks::lowestFree(double s, double radius, HeightRange range) const
{
  const double reach = (radius + largest_radius_) * (1.0 + 2.0 * SPACING);
  const std::size_t column = columnAt(s);
  std::vector<HeightRange> forbidden;
  double height = range.low;
  while (height <= range.high)
  {
    forbidden.clear();
    visitColumns(column, column, {height - reach, height + WINDOW * reach},
                 [&](const PlacedDisk& other, double image)
                 {
                   const double ds = s - other.s - image;
                   const double distance = (radius + other.radius) * (1.0 + SPACING);
                   if (std::abs(ds) >= distance)
                     return;
                   const double half = std::sqrt(distance * distance - ds * ds);
                   if (other.n + half > height)
                     forbidden.push_back({other.n - half, other.n + half});
                 });
    std::sort(forbidden.begin(), forbidden.end(), startsLower);
    const double before = height;
    for (const HeightRange& one : forbidden)
      if (one.low < height)
        height = std::max(height, one.high);
    if (height == before)
      break;
  }
  return height;
}

std::vector<HeightRange> StandingDisks::gaps(double left, double right, double radius,
                                             HeightRange range) const
{
  const double reach = radius + largest_radius_;
  std::vector<HeightRange> forbidden;
  visitColumns(columnAt(left), columnAt(right), {range.low - reach, range.high + reach},
               [&](const PlacedDisk& other, double image)
               {
                 const double ds =
                     std::max(std::abs(left - other.s - image), std::abs(right - other.s - image));
                 const double distance = (radius + other.radius) * (1.0 - SURE);
                 if (ds >= distance)
                   return;
                 const double half = std::sqrt(distance * distance - ds * ds);
                 forbidden.push_back({other.n - half, other.n + half});
               });
  std::sort(forbidden.begin(), forbidden.end(), startsLower);
  std::vector<HeightRange> gaps;
  double height = range.low;
  for (const HeightRange& one : forbidden)
  {
    if (one.low >= range.high)
      break;
    if (one.low >= height)
      gaps.push_back({height, one.low});
    height = std::max(height, one.high);
  }
  if (height <= range.high)
    gaps.push_back({height, range.high});
  return gaps;
}

}  // namespace ratchet_sieve
