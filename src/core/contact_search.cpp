#include "ratchet_sieve/core/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ratchet_sieve/core/quadratic.h"

namespace ratchet_sieve
{
namespace
{
/// A search that took as many steps hands back how far it came, so that one flight cannot hold the
/// rest up. Quadratic convergence needs about six; only grazing flights need more.
constexpr int MAX_STEPS = 64;

/// While the base turns, a step spans no more than this angle [rad]: it keeps the bound on the
/// relative acceleration tight.
constexpr double MAX_TURN_PER_STEP = 0.05;

/// A step looks no further than this many teeth, lest a fast disk over fine teeth looks at them all.
constexpr double MAX_TEETH_PER_STEP = 16.0;

constexpr double INFINITE_TIME = std::numeric_limits<double>::infinity();

double speed(const BasePoint& point)
{
  return std::sqrt(point.vs * point.vs + point.vn * point.vn);
}
}  // namespace

BasePoint toBase(const BaseKinematics& k, double x, double y, double vx, double vy)
{
  const double height = y - k.displacement;
  const double rise = vy - k.velocity;
  BasePoint p;
  p.s = k.cosine * x + k.sine * height;
  p.n = k.cosine * height - k.sine * x;
  p.vs = k.cosine * vx + k.sine * rise + k.inclination_rate * p.n;
  p.vn = k.cosine * rise - k.sine * vx - k.inclination_rate * p.s;
  return p;
}

BasePoint ContactSearch::seenFromBase(const Disk& disk, double time) const
{
  const Disk now = flown(disk, time, gravity_);
  return toBase(motion_.at(time), now.x, now.y, now.vx, now.vy);
}

/// The line along which a disk is accelerated as seen from the base; any while the base turns.
struct ContactSearch::Direction
{
  bool any = true;
  double s = 0.0;
  double n = 0.0;

  /// How much of it shows along a unit normal.
  double share(double normal_s, double normal_n) const
  {
    return any ? 1.0 : std::abs(s * normal_s + n * normal_n);
  }
};

/// One step of the search: the disk as it is, and the shortest time any feature guarantees.
class ContactSearch::Step
{
public:
  /// @param acceleration bounds the relative one; it points along `forced` or against it
  Step(const BasePoint& point, double radius, double acceleration, const Direction& forced, double span,
       double resolution)
      : point(point),
        radius(radius),
        forced_(forced),
        acceleration_(acceleration),
        resolution_(resolution),
        free_time_(span),
        speed_(speed(point))
  {
    updateReach();
  }

  /// How fast the distance to a line with this normal can be accelerated.
  double accelerationAlong(double normal_s, double normal_n) const
  {
    return acceleration_ * forced_.share(normal_s, normal_n);
  }

  /// A point: the distance to it is accelerated whatever its direction.
  void meet(const BaseFeature& feature, double gap, double rate)
  {
    meet(feature, gap, rate, acceleration_, 0.0, 0.0);
  }

  /// A feature that is met where `gap` is used up while `window` holds (window <= 0). Each of the
  /// two alone keeps the disk free, so the longer guarantee counts.
  void meet(const BaseFeature& feature, double gap, double rate, double acceleration, double window,
            double window_rate)
  {
    if (gap > reach_ || window > reach_)
      return;
    const bool within = window <= 0.0;
    double time = guaranteedFreeTime(gap, rate, acceleration);
    const bool touches = within && rate < 0.0 && time <= resolution_;
    if (!within)
      time = std::max(time, guaranteedFreeTime(window, window_rate, acceleration_));
    if (time >= free_time_ && !touches)
      return;
    if (touches && (!contact_ || gap < contact_gap_))
    {
      contact_ = feature;
      contact_gap_ = gap;
    }
    free_time_ = std::min(free_time_, time);
    updateReach();
  }

  bool canReach(double distance_squared) const
  {
    const double reach = reach_ + radius;
    return distance_squared <= reach * reach;
  }

  double freeTime() const { return std::max(free_time_, resolution_); }
  const std::optional<BaseFeature>& contact() const { return contact_; }

  const BasePoint point;
  const double radius;

private:
  void updateReach() { reach_ = (speed_ + 0.5 * acceleration_ * free_time_) * free_time_; }

  Direction forced_;
  double acceleration_;
  double resolution_;
  double free_time_;
  double speed_;
  double reach_ = 0.0;  ///< how far anything can come to the disk within free_time_
  std::optional<BaseFeature> contact_;
  double contact_gap_ = 0.0;
};

BaseEvent ContactSearch::find(const Disk& disk, double radius, double from, double until) const
{
  const Direction forced = forcedDirection();
  double time = nearTime(disk, radius, from);
  for (int i = 0; i < MAX_STEPS; ++i)
  {
    if (time >= until)
      return {time, std::nullopt};
    const BasePoint point = seenFromBase(disk, time);
    const double span = std::min(until - time, longestSpan());
    const double acceleration = relativeAccelerationBound(point, span);
    const double far = MAX_TEETH_PER_STEP * sawtooth_.toothWidth() + radius;
    const double within_far = guaranteedFreeTime(far, -speed(point), acceleration);
    Step step(point, radius, acceleration, forced, std::min(span, within_far), time_resolution_);
    lookAtEnds(step);
    lookAtTeeth(step);
    if (step.contact())
      return {time, step.contact()};
    time += step.freeTime();
    if (point.n > sawtooth_.height() + radius)
      time = nearTime(disk, radius, time);
  }
  return {time, std::nullopt};
}

/// The first time from `from` on at which the base, wherever it is in its oscillation, could reach
/// the disk: closed form, as long as the base does not turn.
double ContactSearch::nearTime(const Disk& disk, double radius, double from) const
{
  if (motion_.turning())
    return from;
  const Disk now = flown(disk, from, gravity_);
  BaseKinematics mount = motion_.at(from);
  mount.displacement = 0.0;
  mount.velocity = 0.0;
  const BasePoint p = toBase(mount, now.x, now.y, now.vx, now.vy);
  const double along = motion_.displacementBound() * std::abs(mount.sine);
  const double across = motion_.displacementBound() * std::abs(mount.cosine);

  double wait = INFINITE_TIME;
  const auto approach = [&wait](double gap, double rate, double accel)
  {
    if (gap <= 0.0)
      wait = 0.0;
    else if (const auto time = firstClosingTime(gap, rate, accel))
      wait = std::min(wait, *time);
  };
  approach(p.n - sawtooth_.height() - radius - across, p.vn, -gravity_ * mount.cosine);
  if (sawtooth_.boundary() != Boundary::PERIODIC)
  {
    const double margin = along + (sawtooth_.boundary() == Boundary::WALLED ? radius : 0.0);
    approach(p.s - margin, p.vs, -gravity_ * mount.sine);
    approach(sawtooth_.width() - margin - p.s, -p.vs, gravity_ * mount.sine);
  }
  return from + wait;
}

double ContactSearch::longestSpan() const
{
  return motion_.turning() ? MAX_TURN_PER_STEP / std::abs(motion_.inclinationRate()) : INFINITE_TIME;
}

/// sup |d2/dt2| of the disk's place in the base's frame over the next `span`: gravity, the drive,
/// and while the base turns at rate w the Coriolis and centrifugal terms, with speed and distance
/// bounded over the span by themselves: K = a + 2 w (v + K T) + w^2 (q + v T + K T^2), solved for K.
double ContactSearch::relativeAccelerationBound(const BasePoint& point, double span) const
{
  const double plain = gravity_ + motion_.accelerationBound();
  double bound = plain;
  if (motion_.turning())
  {
    const double w = std::abs(motion_.inclinationRate());
    const double distance = std::sqrt(point.s * point.s + point.n * point.n);
    const double turn = w * span;
    bound = (plain + 2.0 * w * speed(point) + w * w * (distance + speed(point) * span)) /
            (1.0 - 2.0 * turn - turn * turn);
  }
  return bound;
}

/// Gravity and the drive are both vertical in the world.
ContactSearch::Direction ContactSearch::forcedDirection() const
{
  if (motion_.turning())
    return {};
  return {false, motion_.sine(), motion_.cosine()};
}

void ContactSearch::lookAtEnds(Step& step) const
{
  const auto meet = [&](BaseFeatureKind kind)
  {
    const BaseFeature feature{kind, 0};
    const Approach a = sawtooth_.approach(feature, step.point, step.radius);
    step.meet(feature, a.gap, a.rate, step.accelerationAlong(a.normal_s, a.normal_n), 0.0, 0.0);
  };
  const auto meet_foot = [&](std::int32_t tooth)
  {
    const BaseFeature feature{BaseFeatureKind::END_FOOT, tooth};
    const Approach a = sawtooth_.approach(feature, step.point, step.radius);
    step.meet(feature, a.gap, a.rate);
  };
  if (sawtooth_.boundary() == Boundary::WALLED)
  {
    meet(BaseFeatureKind::LEFT_WALL);
    meet(BaseFeatureKind::RIGHT_WALL);
  }
  else if (sawtooth_.boundary() == Boundary::OPEN)
  {
    meet(BaseFeatureKind::LEFT_END);
    meet(BaseFeatureKind::RIGHT_END);
    meet_foot(0);
    meet_foot(sawtooth_.teeth());
  }
}

/// From the tooth below outwards, as far as the shortest guarantee so far reaches.
void ContactSearch::lookAtTeeth(Step& step) const
{
  const std::int32_t here = sawtooth_.toothAt(step.point.s);
  lookAtTooth(here, step);
  const double above = std::max(0.0, step.point.n - sawtooth_.height());
  const auto reachable = [&](double distance)
  {
    const double beside = std::max(0.0, distance);
    return step.canReach(beside * beside + above * above);
  };
  for (std::int32_t tooth = here - 1;
       sawtooth_.hasTooth(tooth) && reachable(step.point.s - sawtooth_.toothStart(tooth + 1)); --tooth)
    lookAtTooth(tooth, step);
  for (std::int32_t tooth = here + 1;
       sawtooth_.hasTooth(tooth) && reachable(sawtooth_.toothStart(tooth) - step.point.s); ++tooth)
    lookAtTooth(tooth, step);
}

void ContactSearch::lookAtTooth(std::int32_t tooth, Step& step) const
{
  const BasePoint& p = step.point;
  const double s = p.s - sawtooth_.toothStart(tooth);
  const double slack = sawtooth_.windowSlack();
  const auto meet_slope = [&](const Sawtooth::Slope& slope, BaseFeatureKind kind)
  {
    if (!slope.present)
      return;
    const double ds = s - slope.foot_s;
    const double distance = ds * slope.normal_s + p.n * slope.normal_n;
    const double rate = p.vs * slope.normal_s + p.vn * slope.normal_n;
    const double along = ds * slope.along_s + p.n * slope.along_n;
    const double along_rate = p.vs * slope.along_s + p.vn * slope.along_n;
    // The slope can be met only from in front and between its ends.
    double window = -distance - slack;
    double window_rate = -rate;
    if (-along - slack > window)
    {
      window = -along - slack;
      window_rate = -along_rate;
    }
    if (along - slope.length - slack > window)
    {
      window = along - slope.length - slack;
      window_rate = along_rate;
    }
    step.meet({kind, tooth}, distance - step.radius, rate,
              step.accelerationAlong(slope.normal_s, slope.normal_n), window, window_rate);
  };
  meet_slope(sawtooth_.left(), BaseFeatureKind::LEFT_SLOPE);
  meet_slope(sawtooth_.right(), BaseFeatureKind::RIGHT_SLOPE);
  const BaseFeature apex{BaseFeatureKind::APEX, tooth};
  const Approach a = sawtooth_.approach(apex, p, step.radius);
  step.meet(apex, a.gap, a.rate);
}

}  // namespace ratchet_sieve
