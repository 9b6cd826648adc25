#include "search/pair_search.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "model/processor.h"
#include "ratchet_sieve/core/resolution.h"
#include "search/periodic_image_search.h"
#include "search/quadratic.h"

namespace ratchet_sieve
{
namespace
{
/// Largest number of steps of a search across the seam of a turning base, which then assumes contact. Even
/// for grazing disks the steps shrink to two thirds each time, so that the remaining gap is only rounding.
constexpr int MAX_SEAM_STEPS = 200;
}  // namespace

PairContact PairSearch::firstOfSlots(const std::uint32_t* others, std::size_t count, int shift) const
{
  PairContact first;
  const Image image = scene_.image(shift, from_);
  for (std::size_t i = 0; i < count; i += LANES)
    first.take(firstOfLanes(others + i, std::min(LANES, count - i), shift, image));
  return first;
}

/// On a turning base: consecutive disks that are not across the seam are tested together.
PairContact PairSearch::firstOfImages(const std::uint32_t* others, std::size_t count, int shift,
                                      const std::int32_t* images) const
{
  PairContact first;
  std::size_t begin = 0;
  const auto search_row = [&](std::size_t end) { first.take(firstOfSlots(others + begin, end - begin, 0)); };
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t other = others[i];
    const int own_shift = shift + images[other] - images[slot_];
    if (own_shift == 0)
      continue;
    search_row(i);
    begin = i + 1;
    if (const auto time = other == slot_ ? std::nullopt : contactWith(other, own_shift))
      first.take({*time, other, own_shift});
  }
  search_row(count);
  return first;
}

PairContact PairSearch::firstOnRing(const std::uint32_t* others, std::size_t count, int most_laps) const
{
  const BaseMotion& motion = scene_.motion;
  const double width = scene_.width;
  const PeriodicImageSearch ring{motion.rotation(), width, 1.0 / width, most_laps};
  PairContact first;
  double horizon = until_ - from_;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Relative seen = relativeTo(others[i], kinematics_.position);
    const auto touch =
        ring.firstTouch(vectorOf(seen.position), vectorOf(seen.velocity), seen.distance, horizon);
    if (!touch || from_ + touch->time_to_contact >= until_)
      continue;
    first.take({from_ + touch->time_to_contact, others[i], touch->shift});
    horizon = touch->time_to_contact;
  }
  return first;
}

/// SIMD test whether and when a disk touches each of several others.
struct PairSearch::Lanes
{
  // One additional element at the end, which is never touched.
  alignas(Two) std::array<double, LANES + 2> excesses;
  alignas(Two) std::array<double, LANES + 2> discriminants;
  alignas(Two) std::array<double, LANES + 2> closings;
  unsigned touching = 0;  ///< one bit for each that will be touched at any time

  Lanes(const PairSearch& search, const std::uint32_t* others, std::size_t count, const Image& image)
  {
    excesses[LANES] = std::numeric_limits<double>::infinity();
    discriminants[LANES] = 0.0;
    closings[LANES] = -1.0;
    const Two position = search.kinematics_.position - Two{image.shift.x(), image.shift.y()};
    unsigned found = 0;
    for (std::size_t k = 0; k < count; k += 2)
    {
      // For an odd number, the last is tested twice.
      const Relative a = search.relativeTo(others[k], position);
      const Relative b = search.relativeTo(others[std::min(k + 1, count - 1)], position);
      const Two dx{a.position[0], b.position[0]};
      const Two dy{a.position[1], b.position[1]};
      const Two dvx{a.velocity[0], b.velocity[0]};
      const Two dvy{a.velocity[1], b.velocity[1]};
      const Two distance{a.distance, b.distance};
      const Two closing = dx * dvx + dy * dvy;
      const Two excess = dx * dx + dy * dy - distance * distance;
      const Two passing = dx * dvy - dy * dvx;
      const Two discriminant = (dvx * dvx + dvy * dvy) * distance * distance - passing * passing;
      std::memcpy(&closings[k], &closing, sizeof closing);
      std::memcpy(&excesses[k], &excess, sizeof excess);
      std::memcpy(&discriminants[k], &discriminant, sizeof discriminant);
      found |= (whichBelow(closing, 0.0) & (whichUpTo(excess, 0.0) | ~whichBelow(discriminant, 0.0))) << k;
    }
    touching = found & ((1U << count) - 1);
  }

  /// Returns the next that will be touched; the end if there is none.
  std::size_t takeTouching()
  {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(touching | 1U << LANES));
    touching &= touching - 1;
    return lane;
  }

  /// The times to contact of two that will be touched.
  Two timesToContact(std::size_t i, std::size_t j) const
  {
    const Two excess{excesses[i], excesses[j]};
    const Two closing{closings[i], closings[j]};
    const Two time_to_contact = excess / (rootOrZero(Two{discriminants[i], discriminants[j]}) - closing);
    return excess <= 0.0 ? Two{} : time_to_contact;
  }
};

/// The same arithmetic as in contact() and timeToContact(), two disks at a time. First, whether each will be
/// touched, without a branch. Then the times of those that will, four at a time, because most will not, and a
/// root is slow.
PairContact PairSearch::firstOfLanes(const std::uint32_t* others, std::size_t count, int shift,
                                     const Image& image) const
{
  Lanes lanes(*this, others, count, image);
  PairContact first;
  do
  {
    std::array<std::size_t, 4> next;
    for (std::size_t& lane : next)
      lane = lanes.takeTouching();
    const Two a = from_ + lanes.timesToContact(next[0], next[1]);
    const Two b = from_ + lanes.timesToContact(next[2], next[3]);
    const Two least = a < b ? a : b;
    const double earliest = std::min(least[0], least[1]);
    if (earliest >= until_)
      continue;
    for (unsigned found = whichUpTo(a, earliest) | whichUpTo(b, earliest) << 2; found != 0;
         found &= found - 1)
      first.take({earliest, others[next[__builtin_ctz(found)]], shift});
  } while (lanes.touching != 0);
  return first;
}

std::optional<double> PairSearch::contactAcrossSeam(const Disk& other, int shift, double distance) const
{
  if (scene_.motion.turning())
    return contactAcrossTurningSeam(other, shift, distance);
  return contact(other, scene_.image(shift, from_), distance);
}

/// While the base turns, the image moves on an arc. So the search is conservative advancement, as for the
/// base.
std::optional<double> PairSearch::contactAcrossTurningSeam(const Disk& other, int shift,
                                                           double distance) const
{
  const double gravity = scene_.gravity;
  const double rate = scene_.motion.inclinationRate();
  const double acceleration = std::abs(shift) * scene_.width * rate * rate;
  const double resolution = scene_.time_resolution;
  double time = from_;
  for (int step = 0; time < until_; ++step)
  {
    const Kinematics a = kinematicsAt(scene_.disks[slot_], time, gravity);
    const Kinematics b = kinematicsAt(other, time, gravity);
    const Image there = scene_.image(shift, time);
    const Eigen::Vector2d position = vectorOf(a.position) - there.shift - vectorOf(b.position);
    const double length = position.norm();
    const double opening = position.dot(vectorOf(a.velocity - b.velocity) - there.velocity) / length;
    const double free = guaranteedFreeTime(length - distance, opening, acceleration);
    if (opening < 0.0 && (free <= resolution || step > MAX_SEAM_STEPS))
      return time;
    time += std::max(free, resolution);
  }
  return std::nullopt;
}

}  // namespace ratchet_sieve
