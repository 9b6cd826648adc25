#include "ratchet_sieve/core/pour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ratchet_sieve
{
namespace
{
/// Poured disks keep apart by this share of the sum of their radii, so that no rounding makes them
/// overlap.
constexpr double SPACING = 1e-6;

constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();
}  // namespace

Pour::Pour(const BaseDefinition& base, Boundary boundary, double drop_height, double largest_diameter,
           bool see_each_other)
    : width_(base.width()),
      lowest_underside_(base.tooth_height + base.amplitude + drop_height),
      periodic_(boundary == Boundary::PERIODIC),
      see_each_other_(see_each_other)
{
  // With fewer than three buckets a ring's neighbours on both sides would be the same one.
  const double count = std::floor(width_ / std::max(largest_diameter, width_ * 1e-6));
  buckets_.resize(count < 3.0 ? 1 : static_cast<std::size_t>(count), NONE);
  bucket_width_ = width_ / static_cast<double>(buckets_.size());
}

std::size_t Pour::bucketAt(double s) const
{
  const double bucket = std::floor(s / bucket_width_);
  return static_cast<std::size_t>(std::clamp(bucket, 0.0, static_cast<double>(buckets_.size() - 1)));
}

void Pour::reserve(std::size_t disks)
{
  if (see_each_other_)
    occupied_.reserve(disks);
}

void Pour::occupy(const PlacedDisk& disk)
{
  if (!see_each_other_)
    return;
  std::uint32_t& last = buckets_[bucketAt(disk.s)];
  occupied_.push_back({disk, last});
  last = static_cast<std::uint32_t>(occupied_.size() - 1);
}

PlacedDisk Pour::place(double radius, Random& random)
{
  PlacedDisk disk;
  disk.radius = radius;
  const double margin = periodic_ ? 0.0 : radius;
  disk.s = margin + random.uniform() * std::max(0.0, width_ - 2.0 * margin);
  disk.n = lowestFree(disk.s, radius, lowest_underside_ + radius);
  occupy(disk);
  return disk;
}

/// Climbs over the heights that the disks near s forbid.
double Pour::lowestFree(double s, double radius, double lowest) const
{
  std::vector<std::pair<double, double>> forbidden;
  const auto forbid = [&](const PlacedDisk& other, double ds)
  {
    const double distance = (radius + other.radius) * (1.0 + SPACING);
    if (std::abs(ds) >= distance)
      return;
    const double half = std::sqrt(distance * distance - ds * ds);
    if (other.n + half > lowest)
      forbidden.emplace_back(other.n - half, other.n + half);
  };
  const auto count = static_cast<long>(buckets_.size());
  const auto here = static_cast<long>(bucketAt(s));
  for (long bucket = here - (count > 1 ? 1 : 0); bucket <= here + (count > 1 ? 1 : 0); ++bucket)
  {
    if (!periodic_ && (bucket < 0 || bucket >= count))
      continue;
    std::uint32_t at = buckets_[static_cast<std::size_t>((bucket + count) % count)];
    for (; at != NONE; at = occupied_[at].before)
      for (const double image : {-width_, 0.0, width_})
        if (periodic_ || image == 0.0)
          forbid(occupied_[at].disk, s - occupied_[at].disk.s - image);
  }
  std::sort(forbidden.begin(), forbidden.end());
  double height = lowest;
  for (const auto& [from, to] : forbidden)
    if (from < height)
      height = std::max(height, to);
  return height;
}

std::vector<std::uint32_t> pourOrder(const std::vector<SpeciesDefinition>& species, Random& random)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t s = 0; s < species.size(); ++s)
    order.insert(order.end(), static_cast<std::size_t>(species[s].count), s);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

std::uint32_t drawSpecies(const std::vector<SpeciesDefinition>& species, Random& random)
{
  double total = 0.0;
  for (const auto& s : species)
    total += s.share;
  double left = random.uniform() * total;
  for (std::uint32_t s = 0; s + 1 < species.size(); ++s)
  {
    left -= species[s].share;
    if (left < 0.0)
      return s;
  }
  return static_cast<std::uint32_t>(species.size() - 1);
}

}  // namespace ratchet_sieve
