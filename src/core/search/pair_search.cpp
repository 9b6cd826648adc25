#include "search/pair_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "model/processor.h"
#include "ratchet_sieve/core/resolution.h"
#include "search/contact_search.h"

namespace ratchet_sieve
{
namespace
{
/// Largest number of steps of a search across the seam of a turning base, which then assumes contact. Even
/// for grazing disks the steps shrink to two thirds each time, so that the remaining gap is only rounding.
constexpr int MAX_SEAM_STEPS = 200;

/// Images are tested up to this fraction of the contact distance beyond it, to allow for rounding. The exact
/// test follows, as for any two disks.
constexpr double REACH_MARGIN = 0.005;

/// A smaller speed towards the row counts as 0 [m/s]. Keeps times finite.
constexpr double AT_REST = 1e-200;

/// The smallest integer not below x. @pre it fits into an int
int roundedUp(double x)
{
  const int truncated = static_cast<int>(x);
  return truncated + (truncated < x ? 1 : 0);
}
}  // namespace

PairContact PairSearch::firstAmong(const std::uint32_t* others, std::size_t count, int shift) const
{
  PairContact first;
  const Image image = scene_.image(shift, from_);
  for (std::size_t i = 0; i < count; i += LANES)
    first.keepEarlier(firstOfLanes(others + i, std::min(LANES, count - i), shift, image));
  return first;
}

/// On a turning base: consecutive disks that are not across the seam are tested together.
PairContact PairSearch::firstAmong(const std::uint32_t* others, std::size_t count, int shift,
                                   const std::int32_t* images) const
{
  PairContact first;
  std::size_t begin = 0;
  const auto search_row = [&](std::size_t end)
  { first.keepEarlier(firstAmong(others + begin, end - begin, 0)); };
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t other = others[i];
    const int own_shift = shift + images[other] - images[slot_];
    if (own_shift == 0)
      continue;
    search_row(i);
    begin = i + 1;
    if (const auto time = other == slot_ ? std::nullopt : contactWith(other, own_shift))
      first.keepEarlier({*time, other, own_shift});
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
    const Relative seen = line_.seenFrom(scene_.disks[others[i]], from_);
    const auto touch =
        ring.firstTouch(vectorOf(seen.position), vectorOf(seen.velocity), seen.distance, horizon);
    if (!touch || from_ + touch->time_to_contact >= until_)
      continue;
    first.keepEarlier({from_ + touch->time_to_contact, others[i], touch->shift});
    horizon = touch->time_to_contact;
  }
  return first;
}

std::optional<PeriodicImageSearch::Touch> PeriodicImageSearch::firstTouch(const Eigen::Vector2d& position,
                                                                          const Eigen::Vector2d& velocity,
                                                                          double distance,
                                                                          double horizon) const
{
  const double reach = distance * (1.0 + REACH_MARGIN);
  const auto in_row = intoBase(rotation, position.x(), position.y());
  const auto going = intoBase(rotation, velocity.x(), velocity.y());
  const double across = in_row.second;
  const double rising = going.second;
  if (std::abs(across) >= reach && across * rising >= 0.0)
    return std::nullopt;
  // The time interval in which the row is within reach.
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
  if (std::abs(rising) > AT_REST)
  {
    const double per_rising = 1.0 / rising;
    const double half = reach * std::abs(per_rising);
    from = std::max(0.0, -across * per_rising - half);
    to = -across * per_rising + half;
  }
  if (from > horizon)
    return std::nullopt;

  // Along the row in widths, oriented so that the disk flies towards greater positions.
  const double rate = going.first * per_width;
  const double sign = rate < 0.0 ? -1.0 : 1.0;
  const double along = sign * in_row.first * per_width;
  const double speed = std::abs(rate);
  const double margin = reach * per_width;
  const double limit = most_laps;
  const double last = speed > 0.0 ? along + speed * std::min(to, horizon) : along;
  const double begin = std::max(along + speed * from - margin, -limit);
  const double end = std::min(last + margin, limit);
  if (begin > end)
    return std::nullopt;
  std::optional<Touch> first;
  for (int image = roundedUp(begin); image <= end; ++image)
  {
    // The images are reached one after the other.
    if (first && image - margin > along + speed * first->time_to_contact)
      break;
    const double shift = sign * image;
    const auto there = alongBase(rotation, shift * width);
    const auto time_to_contact =
        timeToContact(position - Eigen::Vector2d(there.first, there.second), velocity, distance);
    if (time_to_contact && *time_to_contact <= horizon &&
        !(first && first->time_to_contact <= *time_to_contact))
      first = Touch{*time_to_contact, static_cast<int>(shift)};
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
    const SlotArray<Disk>& disks = search.scene_.disks;
    const FlightLine line(disks[search.slot_], image.shift);
    unsigned found = 0;
    for (std::size_t k = 0; k < count; k += 2)
    {
      // For an odd number, the last is tested twice.
      const Relative a = line.seenFrom(disks[others[k]], search.from_);
      const Relative b = line.seenFrom(disks[others[std::min(k + 1, count - 1)]], search.from_);
      const Two dx{a.position[0], b.position[0]};
      const Two dy{a.position[1], b.position[1]};
      const Two dvx{a.velocity[0], b.velocity[0]};
      const Two dvy{a.velocity[1], b.velocity[1]};
      const Two distance{a.distance, b.distance};
      const Two closing = dx * dvx + dy * dvy;
      const Two squared_distance = distance * distance;
      const Two excess = dx * dx + dy * dy - squared_distance;
      const Two passing = dx * dvy - dy * dvx;
      const Two discriminant = (dvx * dvx + dvy * dvy) * squared_distance - passing * passing;
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

/// Computes as contactWith() and timeToContact() do, two disks at a time. First, whether each will be
/// touched, without a branch. Then the times of those that will, four at a time, because most will not, and a
/// root is slow.
inline PairContact PairSearch::firstOfLanes(const std::uint32_t* others, std::size_t count, int shift,
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
    const Two least = smaller(a, b);
    const double earliest = std::min(least[0], least[1]);
    if (earliest >= until_)
      continue;
    for (unsigned found = whichUpTo(a, earliest) | whichUpTo(b, earliest) << 2; found != 0;
         found &= found - 1)
      first.keepEarlier({earliest, others[next[__builtin_ctz(found)]], shift});
  } while (lanes.touching != 0);
  return first;
}

/// While the base turns, the image moves on an arc. So the search is conservative advancement, as for the
/// base.
std::optional<double> PairSearch::contactAcrossTurningSeam(const Disk& other, int shift) const
{
  const double rate = scene_.motion.inclinationRate();
  const double acceleration = std::abs(shift) * scene_.width * rate * rate;
  const double resolution = scene_.time_resolution;
  double time = from_;
  for (int step = 0; time < until_; ++step)
  {
    const Image there = scene_.image(shift, time);
    const Relative seen = FlightLine(scene_.disks[slot_], there.shift).seenFrom(other, time);
    const Eigen::Vector2d position = vectorOf(seen.position);
    const double length = position.norm();
    const double opening = position.dot(vectorOf(seen.velocity) - there.velocity) / length;
    const double free = guaranteedFreeTime(length - seen.distance, opening, acceleration);
    const double next = time + std::max(free, resolution);
    // The second case: so far ahead that the step is lost to rounding. Other events come first, or the
    // contact is found separating and the search begins anew.
    if ((opening < 0.0 && (free <= resolution || step > MAX_SEAM_STEPS)) || next == time)
      return time;
    time = next;
  }
  return std::nullopt;
}

}  // namespace ratchet_sieve
