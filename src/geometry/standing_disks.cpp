#include "ratchet_sieve/geometry/standing_disks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

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

/// Beyond so many classes below the largest, disks are in the last.
constexpr double MOST_CLASSES = 16.0;

/// Range of heights searched at once, in radii.
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

StandingDisks::StandingDisks(double width, bool periodic, double largest_diameter,
                             std::pmr::memory_resource& memory)
    : width_(width), periodic_(periodic), largest_radius_(0.5 * largest_diameter), memory_(memory)
{
}

/// With fewer than three columns on a ring, the neighbours on both sides would be the same column.
double StandingDisks::columnsFor(double diameter) const
{
  const double count = std::floor(width_ / std::max(diameter, width_ * 1e-6));
  return count < 3.0 ? 1.0 : count;
}

StandingDisks::SizeClass& StandingDisks::classOf(double radius)
{
  const double halvings = std::floor(std::log2(largest_radius_ / radius));
  const auto at = static_cast<std::size_t>(std::clamp(halvings, 0.0, MOST_CLASSES - 1.0));
  while (classes_.size() <= at)
  {
    SizeClass next;
    next.radius = std::ldexp(largest_radius_, -static_cast<int>(classes_.size()));
    const double columns = columnsFor(2.0 * next.radius);
    next.column_width = width_ / columns;
    next.columns.reserve(static_cast<std::size_t>(columns));
    while (next.columns.size() < next.columns.capacity())
      next.columns.emplace_back(memory_);
    classes_.push_back(std::move(next));
  }
  return classes_[at];
}

/// The first column without an end to the left, the last without one to the right.
std::ptrdiff_t StandingDisks::columnAt(const SizeClass& of, double s)
{
  const double column = std::floor(s / of.column_width);
  return static_cast<std::ptrdiff_t>(std::clamp(column, 0.0, static_cast<double>(of.columns.size() - 1)));
}

/// A single disk is usually near the top and is inserted in order; many disks added before the first search
/// are sorted once.
void StandingDisks::add(const PlacedDisk& disk)
{
  SizeClass& of = classOf(disk.radius);
  Column& column = of.columns[static_cast<std::size_t>(columnAt(of, disk.s))];
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

/// Calls visit(disk, shift) for the disks that a disk of this radius, between `left` and `right` and in this
/// range of heights, may touch, and for each of their images, `shift` to the right [m].
template <typename Visit>
void StandingDisks::visitReach(double left, double right, double radius, HeightRange heights,
                               Visit&& visit) const
{
  for (const SizeClass& of : classes_)
  {
    const double reach = (radius + of.radius) * (1.0 + 2.0 * SPACING);
    const auto count = static_cast<std::ptrdiff_t>(of.columns.size());
    const auto beside = static_cast<std::ptrdiff_t>(std::ceil(reach / of.column_width));
    std::ptrdiff_t first = columnAt(of, left) - beside;
    std::ptrdiff_t last = columnAt(of, right) + beside;
    if (last - first >= count || !periodic_)
    {
      first = std::max<std::ptrdiff_t>(first, 0);
      last = std::min(last, count - 1);
      if (periodic_)
        last = (first = 0) + count - 1;
    }
    for (std::ptrdiff_t at = first; at <= last; ++at)
    {
      const Column& column = of.columns[static_cast<std::size_t>((at + count) % count)];
      sort(column);
      auto disk = std::lower_bound(column.disks.begin(), column.disks.end(),
                                   PlacedDisk{0.0, heights.low - reach, 0.0}, isLower);
      for (; disk != column.disks.end() && disk->n <= heights.high + reach; ++disk)
        for (const double image : {-width_, 0.0, width_})
          if (periodic_ || image == 0.0)
            visit(*disk, image);
    }
  }
}

double StandingDisks::lowestFree(double s, double radius, HeightRange range) const
{
  std::vector<HeightRange> forbidden;
  double height = range.low;
  while (height <= range.high)
  {
    forbidden.clear();
    visitReach(s, s, radius, {height, height + WINDOW * radius},
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
  std::vector<HeightRange> forbidden;
  visitReach(left, right, radius, range,
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
