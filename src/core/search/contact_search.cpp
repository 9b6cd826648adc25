#include "search/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "search/contact_step.h"

namespace ratchet_sieve
{
namespace
{
/// Largest number of steps of one search, which then returns the time reached, so that one flight does not
/// delay the others. Quadratic convergence needs about six; only grazing flights need more.
constexpr int MAX_STEPS = 64;

/// Newton's method needs three or four steps, and one more from a bad start.
constexpr int MAX_REFINEMENTS = 12;

/// Largest rotation of a turning base in one step [rad]; keeps the bound on the relative acceleration tight.
constexpr double MAX_TURN_PER_STEP = 0.05;

/// Largest number of sections of the base in one step. Otherwise a fast disk over fine teeth tests them all.
constexpr double MAX_SECTIONS_PER_STEP = 16.0;
}  // namespace

BaseEvent ContactSearch::find(const Disk& disk, const Kinematics& from, double until, BaseInstant& base) const
{
  if (staysAbove(disk, from, until, base))
    return {until, {}};
  const double radius = disk.radius;
  const Direction forced = forcedDirection();
  double time = nearTime(radius, from);
  for (int i = 0; i < MAX_STEPS; ++i)
  {
    if (time >= until)
      return {time, {}};
    const BasePoint point = time == from.time ? base.at(time).see(from) : seenFromBase(disk, time);
    const double span = std::min(until - time, longestSpan());
    const double acceleration = relativeAccelerationBound(point, span);
    Step step(point, radius, acceleration, forced, span, time_resolution_);
    step.limitTo(MAX_SECTIONS_PER_STEP * shape_.sectionWidth() + radius);
    if (shape_.boundary() != Boundary::PERIODIC || motion_.turning())
      testEnds(step);
    if (!step.staysOver(shape_.height()))
      testTeeth(step);
    if (step.contact())
      return {time, step.contact()};
    if (const SureContact* sure = step.sureContact())
      if (const auto contact = refine(disk, *sure, time))
        return {*contact, sure->feature};
    time += step.freeTime();
    if (point.n() > shape_.height() + radius)
      time = nearTime(radius, kinematicsAt(disk, time, gravity_));
  }
  return {time, {}};
}

/// Newton's method on the gap to the one feature that is certain to be hit. The gap decreases throughout the
/// interval, so there is one root. Nothing if it does not converge.
std::optional<double> ContactSearch::refine(const Disk& disk, const SureContact& sure, double time) const
{
  const double earliest = time + sure.earliest;
  const double latest = time + sure.latest;
  double at = std::clamp(time - sure.gap / sure.rate, earliest, latest);
  for (int i = 0; i < MAX_REFINEMENTS; ++i)
  {
    const Approach now = shape_.approach(sure.feature, seenFromBase(disk, at), disk.radius);
    if (!(now.rate < 0.0))
      return std::nullopt;
    const double step = -now.gap / now.rate;
    at = std::clamp(at + step, earliest, latest);
    // The next step would not be longer than K step^2 / (2 |rate|).
    if (0.5 * sure.acceleration * step * step <= -now.rate * time_resolution_)
      return at;
  }
  return std::nullopt;
}

/// Whether the disk is above the highest position of the base at both ends of a time span. Then it is so in
/// between, because it falls towards the base; this does not hold for an inclination beyond 90 degrees. Needs
/// comparisons only, while nearTime() takes a root. May return false although it is true.
bool ContactSearch::staysAbove(const Disk& disk, const Kinematics& from, double until,
                               BaseInstant& base) const
{
  if (shape_.boundary() != Boundary::PERIODIC)
    return false;
  if (motion_.turning())
    return staysAboveTurning(disk, from, until, base.at(from.time).rotation);
  const Rotation& rotation = motion_.rotation();
  if (rotation.cosine <= 0.0)
    return false;
  const double top = shape_.height() + disk.radius + motion_.reach().y();
  const auto above = [&](Two position) { return intoBase(rotation, position[0], position[1]).second > top; };
  return above(from.position) && above(kinematicsAt(disk, until, gravity_).position);
}

/// The same while the base turns, and whether the disk stays between the ends of the base.
/// @param rotation at `from`
bool ContactSearch::staysAboveTurning(const Disk& disk, const Kinematics& from, double until,
                                      const Rotation& rotation) const
{
  const double span = until - from.time;
  const double turn = std::abs(motion_.inclinationRate()) * span;
  if (!(turn <= MAX_TURN_PER_STEP) || rotation.cosine <= 0.0)
    return false;
  const auto seen = [&](Two position) { return intoBase(rotation, position[0], position[1]); };
  const auto before = seen(from.position);
  const auto after = seen(kinematicsAt(disk, until, gravity_).position);
  const double bend = 0.125 * gravity_ * span * span;
  const double first = std::min(before.first, after.first) - bend;
  const double last = std::max(before.first, after.first) + bend;
  const double lowest = std::min(before.second, after.second);
  const double highest = std::max(before.second, after.second) + bend;
  // In the axes of `from`, what is at a distance from the foot moves by no more than the turn times that; the
  // distance itself appears smaller by half the square of the turn.
  const double margin =
      motion_.displacementBound().norm() + turn * (1.0 + turn) * (highest + std::max(-first, last));
  return lowest > shape_.height() + disk.radius + margin && first > margin && last < shape_.width() - margin;
}

/// The first time after `from` at which the base, at any phase of its oscillation, could reach the disk.
/// Closed form, valid while the base does not turn.
double ContactSearch::nearTime(double radius, const Kinematics& from) const
{
  if (motion_.turning())
    return from.time;
  FrameOfBase mount;
  mount.rotation = motion_.rotation();
  const BasePoint p = mount.see(from);
  const Eigen::Vector2d& reach = motion_.reach();
  const auto fall = verticalIntoBase(mount.rotation, -gravity_);

  double time_to_band = INFINITE_TIME;
  const auto approach = [&time_to_band](double gap, double rate, double accel)
  {
    if (gap <= 0.0)
      time_to_band = 0.0;
    else if (const auto time = firstClosingTime(gap, rate, accel))
      time_to_band = std::min(time_to_band, *time);
  };
  approach(p.n() - shape_.height() - radius - reach.y(), p.velocity.y(), fall.second);
  if (shape_.boundary() != Boundary::PERIODIC)
  {
    const double margin = reach.x() + (shape_.boundary() == Boundary::WALLED ? radius : 0.0);
    approach(p.s() - margin, p.velocity.x(), fall.first);
    approach(shape_.width() - margin - p.s(), -p.velocity.x(), -fall.first);
  }
  return from.time + time_to_band;
}

double ContactSearch::longestSpan() const
{
  return motion_.turning() ? MAX_TURN_PER_STEP / std::abs(motion_.inclinationRate()) : INFINITE_TIME;
}

/// sup |d2/dt2| of the disk's position in the base's frame over the next `span`: gravity, the drive, and
/// while the base turns at rate w the Coriolis and centrifugal terms. Speed and distance over the span are
/// bounded through K itself: K = a + 2 w (v + K T) + w^2 (q + v T + K T^2), solved for K.
double ContactSearch::relativeAccelerationBound(const BasePoint& point, double span) const
{
  const double plain = gravity_ + motion_.greatestAcceleration();
  if (!motion_.turning())
    return plain;
  const double w = std::abs(motion_.inclinationRate());
  const double distance = point.position.norm();
  const double turn = w * span;
  return (plain + 2.0 * w * speedBound(point) + w * w * (distance + speedBound(point) * span)) /
         (1.0 - 2.0 * turn - turn * turn);
}

/// Gravity is vertical in the world, and so is the drive of the paper's machine. relativeAccelerationBound()
/// includes all other terms.
ContactSearch::Direction ContactSearch::forcedDirection() const
{
  if (motion_.turning())
    return {};
  const auto vertical = verticalIntoBase(motion_.rotation(), 1.0);
  Direction forced;
  forced.any = false;
  forced.upright = {vertical.first, vertical.second};
  const Eigen::Vector2d& drive = motion_.accelerationBound();
  if (drive.x() > 0.0)
  {
    const double all = gravity_ + motion_.greatestAcceleration();
    const auto horizontal = intoBase(motion_.rotation(), 1.0, 0.0);
    forced.oblique = true;
    forced.upright *= (gravity_ + drive.y()) / all;
    forced.sideways = Eigen::Vector2d(horizontal.first, horizontal.second) * (drive.x() / all);
  }
  return forced;
}

/// The walls, if there are any. For open ends and above the walls: the lines at which a disk leaves, and the
/// corners that it may touch on its way. For a turning periodic base: the lines at its ends, at which a disk
/// is wrapped.
void ContactSearch::testEnds(Step& step) const
{
  const auto test_line = [&](BaseFeatureKind kind, const Step::Gap& window)
  {
    const BaseFeature feature{kind, 0};
    const Approach a = shape_.approach(feature, step.point, step.radius);
    step.testLine(feature, a.gap, a.rate, a.normal, [&] { return window; });
  };
  const auto test_corner = [&](std::int32_t tooth)
  {
    const BaseFeature feature{BaseFeatureKind::END_CORNER, tooth};
    step.testPoint(feature, shape_.approach(feature, step.point, step.radius));
  };
  if (shape_.boundary() == Boundary::WALLED)
  {
    const double top = shape_.wallHeight();
    const bool below = step.staysBelow(top);
    const Step::Gap window = below ? Step::ALWAYS : Step::Gap{step.point.n() - top, step.point.velocity.y()};
    test_line(BaseFeatureKind::LEFT_WALL, window);
    test_line(BaseFeatureKind::RIGHT_WALL, window);
    if (below)
      return;
  }
  const double inside = std::min(step.point.s(), shape_.width() - step.point.s());
  if (shape_.boundary() == Boundary::PERIODIC && inside > 0.0 && !step.canReach(inside * inside))
    return;
  test_line(BaseFeatureKind::LEFT_END, Step::ALWAYS);
  test_line(BaseFeatureKind::RIGHT_END, Step::ALWAYS);
  if (shape_.boundary() == Boundary::PERIODIC)
    return;
  test_corner(0);
  test_corner(shape_.teeth());
}

void ContactSearch::testSection(std::int32_t tooth, const BaseShape::Section& section, Step& step) const
{
  const BasePoint& p = step.point;
  const double s = p.s() - shape_.toothStart(tooth);
  for (const BaseShape::Face* face = section.first_face; face != section.end_face; ++face)
  {
    const Eigen::Vector2d from_foot(s - face->foot.x(), p.n() - face->foot.y());
    const double distance = from_foot.dot(face->normal);
    const double rate = p.velocity.dot(face->normal);
    // A contact with the face must be between its ends, and on its front side.
    const auto window = [&]
    {
      const double along = from_foot.dot(face->along);
      const double along_rate = p.velocity.dot(face->along);
      const double slack = shape_.windowSlack();
      Step::Gap latest{-distance - slack, -rate};
      if (-along - slack > latest.size)
        latest = {-along - slack, -along_rate};
      if (along - face->length - slack > latest.size)
        latest = {along - face->length - slack, along_rate};
      return latest;
    };
    step.testLine({BaseFeatureKind::FACE, tooth, face->number}, distance - step.radius, rate, face->normal,
                  window);
  }
  for (const BaseShape::Corner* corner = section.first_corner; corner != section.end_corner; ++corner)
  {
    const Eigen::Vector2d way(s - corner->position.x(), p.n() - corner->position.y());
    if (step.canReach(way.squaredNorm()))
      step.testPoint({BaseFeatureKind::CORNER, tooth, corner->number}, approachToPoint(way, p, step.radius));
  }
}

/// From the section below the disk outwards, as far as the shortest guaranteed time reaches.
void ContactSearch::testTeeth(Step& step) const
{
  const double above = std::max(0.0, step.point.n() - shape_.height());
  shape_.visitOutwards(
      step.point.s(),
      [&](double distance)
      {
        const double beside = std::max(0.0, distance);
        return step.canReach(beside * beside + above * above);
      },
      [&](std::int32_t tooth, const BaseShape::Section& section) { testSection(tooth, section, step); });
}

}  // namespace ratchet_sieve
