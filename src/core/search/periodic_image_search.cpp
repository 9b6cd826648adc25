#include "search/periodic_image_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "search/pair_search.h"

namespace ratchet_sieve
{
namespace
{
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

}  // namespace ratchet_sieve
