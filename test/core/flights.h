#pragma once

#include <algorithm>
#include <cmath>

#include <rapidcheck.h>

#include "draws.h"
#include "model/disk.h"
#include "profiles.h"
#include "search/contact_search.h"

/// Bases, flights of single disks over them, and a brute force search for their first contact.
namespace ratchet_sieve::test
{

constexpr double HORIZON = 0.4;  ///< of the searches [s]

/// Straight and oblique, circular, or with arbitrary harmonics.
inline void drawOrbit(BaseDefinition& base)
{
  base.horizontal_amplitude = *rc::gen::element(0.0, 0.002, -0.005, 0.01);
  base.horizontal_phase = *rc::gen::element(0.0, 1.5707963267948966, 4.0);
  for (int count = *rc::gen::inRange(0, 3); count > 0; --count)
    base.harmonics.push_back({*rc::gen::inRange(2, 8), drawn(-0.001, 0.001), drawn(0.0, 6.28),
                              drawn(-0.001, 0.001), drawn(0.0, 6.28)});
}

/// One of several difficult shapes: plain, vertical faces, flat, needles, fine and coarse teeth, upside down.
/// @param corners of a profile, at most
inline BaseDefinition drawnBase(int corners)
{
  BaseDefinition base;
  base.teeth = 5;
  base.asymmetry = *rc::gen::element(0.0, 0.1, 0.3, 0.5, 0.9, 1.0);
  base.tooth_height = *rc::gen::element(0.0, 0.001, 0.006, 0.06);
  base.inclination = *rc::gen::element(0.0, 0.209, -0.1, 1.2, 2.5);
  base.amplitude = *rc::gen::element(0.0, 0.002, 0.01);
  base.phase = drawn(0.0, 6.28);
  if (*rc::gen::arbitrary<bool>())
    base.profile = drawnProfile(0.02, std::max(0.001, base.tooth_height), corners);
  if (*rc::gen::arbitrary<bool>())
    drawOrbit(base);
  return base;
}

inline double gapBelow(const BaseShape& shape, const BasePoint& point, double radius)
{
  return std::min(shape.heightAbove(point.s(), point.n()), shape.distanceToWalls(point.s(), point.n())) -
         radius;
}

/// A disk that starts anywhere free of the base, in any direction, up to `speed` along each axis [m/s].
/// @param down whether it starts where it nearly touches
inline Disk drawnFlight(const BaseMotion& motion, const BaseShape& shape, double radius, double speed,
                        bool down = false)
{
  const double s = std::fmod(drawn(radius, 0.1 - radius * (radius < 0.05)), shape.width());
  double n = radius + drawn(0.0, 0.03);
  while (gapBelow(shape, {{s, n}, {}}, radius) < 0.0)
    n += 0.1 * radius;
  while (down && shape.heightAbove(s, n) > radius * (1.0 + 1e-9))
    n -= shape.heightAbove(s, n) - radius;
  const Eigen::Vector2d place = motion.at(0.0).positionOutOf({s, n});
  Disk disk;
  disk.radius = radius;
  disk.position.x() = place.x();
  disk.position.y() = place.y();
  disk.velocity.x() = drawn(-speed, speed);
  disk.velocity.y() = drawn(-speed, speed);
  return disk;
}

/// Searches from event to event until a contact is certain, as the loops do.
inline BaseEvent searchOn(const ContactSearch& search, const Disk& disk)
{
  BaseEvent event{0.0, {}};
  for (int i = 0; i < 2000 && !event.feature && event.time < HORIZON; ++i)
    event = search.find(disk, event.time, HORIZON);
  return event;
}

/// At many times before the contact, the disk does not touch or leave. At the contact, the rim touches and
/// approaches, or the centre reaches the machine's end.
/// @param tolerance [m]
inline void checkAgainstScan(const ContactSearch& search, const BaseShape& shape, const Disk& disk,
                             const BaseEvent& event, double tolerance)
{
  const double end = std::min(event.time, HORIZON);
  for (int i = 0; i < 2000; ++i)
  {
    const BasePoint point = search.seenFromBase(disk, end * i / 2000.0);
    RC_ASSERT(gapBelow(shape, point, disk.radius) > -tolerance);
    RC_ASSERT(shape.boundary() == Boundary::PERIODIC ||
              (point.s() > -tolerance && point.s() < shape.width() + tolerance));
  }
  RC_CLASSIFY(!event.feature, "no contact");
  if (!event.feature)
    return;
  const BasePoint point = search.seenFromBase(disk, event.time);
  const Approach approach = shape.approach(event.feature, point, disk.radius);
  RC_ASSERT(std::abs(approach.gap) < tolerance);
  RC_ASSERT(approach.rate < 1e-9);
  const double gap = gapBelow(shape, point, disk.radius);
  RC_ASSERT(gap > -tolerance);
  RC_ASSERT(gap < tolerance || event.feature.isEnd());
}

}  // namespace ratchet_sieve::test
