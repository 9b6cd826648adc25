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

/// Newton's method takes three or four steps, and one more where it starts badly.
constexpr int MAX_POLISHING = 12;

/// While the base turns, a step spans no more than this angle [rad]: it keeps the bound on the
/// relative acceleration tight.
constexpr double MAX_TURN_PER_STEP = 0.05;

/// A step looks no further than this many teeth, lest a fast disk over fine teeth looks at them all.
constexpr double MAX_TEETH_PER_STEP = 16.0;

constexpr double INFINITE_TIME = std::numeric_limits<double>::infinity();

/// No less than the speed: where only a bound is needed, that saves the root.
double speedBound(const BasePoint& point)
{
  return std::abs(point.vs) + std::abs(point.vn);
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

BasePoint ContactSearch::seenFromBase(const Disk& disk, const BaseKinematics& base, double time) const
{
  const Course now = courseAt(disk, time, gravity_);
  return toBase(base, now.place[0], now.place[1], now.velocity[0], now.velocity[1]);
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

/// One step of the search: the disk as it is, the shortest time any feature guarantees, and whether one
/// feature is sure to be met before any other.
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
        horizon_(span),
        others_free_time_(span),
        speed_(speedBound(point))
  {
    updateReach();
  }

  /// Ends the step before anything can have come as near as this.
  void noFurtherThan(double distance)
  {
    if (reach_ <= distance)
      return;
    free_time_ = horizon_ = others_free_time_ = guaranteedFreeTime(distance, -speed_, acceleration_);
    updateReach();
  }

  /// A slope or a wall, met where `gap` is used up; what a slope is met through besides comes as `window`.
  /// @param normal_s, normal_n of the line
  template <typename FindWindow>
  void meetLine(const BaseFeature& feature, double gap, double rate, double normal_s, double normal_n,
                FindWindow&& find_window)
  {
    // How fast the distance to the line can be accelerated.
    const double acceleration = acceleration_ * forced_.share(normal_s, normal_n);
    if (!staysFree(gap, rate, acceleration))
      meet(feature, {gap, rate}, acceleration, acceleration, find_window());
  }

  /// A corner. The distance to it is accelerated whatever its direction, and by passing, too.
  void meetPoint(const BaseFeature& feature, const Approach& approach)
  {
    if (staysFree(approach.gap, approach.rate, acceleration_))
      return;
    const double top_speed = speed_ + acceleration_ * horizon_;
    const double parting = acceleration_ + top_speed * top_speed / radius;
    meet(feature, {approach.gap, approach.rate}, acceleration_, parting, ALWAYS);
  }

  bool canReach(double distance_squared) const
  {
    const double reach = reach_ + radius;
    return distance_squared <= reach * reach;
  }

  /// Whether the disk is higher over the base than this all through the step.
  bool staysOver(double height) const
  {
    return staysFree(point.n - height - radius, point.vn, acceleration_);
  }

  double freeTime() const { return std::max(free_time_, resolution_); }

  /// What the disk touches now.
  const std::optional<BaseFeature>& contact() const { return contact_; }

  /// What the disk will meet for certain, and before anything else.
  const SureContact* sureContact() const { return sure_.latest <= others_free_time_ ? &sure_ : nullptr; }

  const BasePoint& point;
  const double radius;

  struct Gap
  {
    double size;
    double rate;
  };
  static constexpr Gap ALWAYS{-INFINITE_TIME, 0.0};

private:
  /// A feature that is met where `gap` is used up while `window` holds (window <= 0). Each of the
  /// two alone keeps the disk free, so the longer guarantee counts.
  /// @param approaching, parting bound the gap's acceleration towards the feature and away from it
  void meet(const BaseFeature& feature, const Gap& gap, double approaching, double parting, const Gap& window)
  {
    if (staysFree(window.size, window.rate, acceleration_))
      return;
    const bool within = window.size <= 0.0;
    double time = guaranteedFreeTime(gap.size, gap.rate, approaching);
    if (!within)
      time = std::max(time, guaranteedFreeTime(window.size, window.rate, acceleration_));
    else if (gap.rate < 0.0 && time <= resolution_ && (!contact_ || gap.size < contact_gap_))
    {
      contact_ = feature;
      contact_gap_ = gap.size;
    }
    const double latest = within ? latestContact(gap, parting, window) : INFINITE_TIME;
    if (latest < sure_.latest)
    {
      others_free_time_ = std::min(others_free_time_, sure_.earliest);
      sure_ = {feature, gap.size, gap.rate, time, latest, parting};
    }
    else
      others_free_time_ = std::min(others_free_time_, time);
    free_time_ = std::min(free_time_, time);
    horizon_ = std::min(horizon_, std::isfinite(latest) ? latest : time);
    updateReach();
  }

  /// By when a gap that closes is used up for certain, the window open all the time; else never.
  double latestContact(const Gap& gap, double parting, const Gap& window) const
  {
    const double discriminant = gap.rate * gap.rate - 2.0 * parting * gap.size;
    if (gap.rate >= 0.0 || gap.size <= 0.0 || discriminant <= 0.0)
      return INFINITE_TIME;
    const double latest = 2.0 * gap.size / (std::sqrt(discriminant) - gap.rate);
    const bool stays_open = window.size + (speed_ + 0.5 * acceleration_ * latest) * latest <= 0.0;
    return stays_open ? latest : INFINITE_TIME;
  }

  void updateReach() { reach_ = (speed_ + 0.5 * acceleration_ * horizon_) * horizon_; }

  /// Whether a gap is open for as long as matters: a comparison, where the time itself takes a root.
  bool staysFree(double gap, double rate, double acceleration) const
  {
    const double span = std::max(horizon_, resolution_);
    return gap > 0.0 && gap + (rate - 0.5 * acceleration * span) * span > 0.0;
  }

  const Direction& forced_;
  double acceleration_;
  double resolution_;
  double free_time_;
  double horizon_;           ///< what is free until then does not matter
  double others_free_time_;  ///< guaranteed by all features but the sure one
  double speed_;
  double reach_ = 0.0;  ///< how far anything can come to the disk within the horizon
  std::optional<BaseFeature> contact_;
  double contact_gap_ = 0.0;
  SureContact sure_;
};

BaseEvent ContactSearch::find(const Disk& disk, double radius, double from, double until,
                              BaseInstant& base) const
{
  if (staysAbove(disk, radius, from, until))
    return {until, std::nullopt};
  const Direction forced = forcedDirection();
  double time = nearTime(disk, radius, from);
  for (int i = 0; i < MAX_STEPS; ++i)
  {
    if (time >= until)
      return {time, std::nullopt};
    const BasePoint point = seenFromBase(disk, i == 0 ? base.at(time) : motion_.at(time), time);
    const double span = std::min(until - time, longestSpan());
    const double acceleration = relativeAccelerationBound(point, span);
    Step step(point, radius, acceleration, forced, span, time_resolution_);
    step.noFurtherThan(MAX_TEETH_PER_STEP * sawtooth_.toothWidth() + radius);
    if (sawtooth_.boundary() != Boundary::PERIODIC)
      lookAtEnds(step);
    if (!step.staysOver(sawtooth_.height()))
      lookAtTeeth(step);
    if (step.contact())
      return {time, step.contact()};
    if (const SureContact* sure = step.sureContact())
      if (const auto contact = polish(disk, radius, *sure, time))
        return {*contact, sure->feature};
    time += step.freeTime();
    if (point.n > sawtooth_.height() + radius)
      time = nearTime(disk, radius, time);
  }
  return {time, std::nullopt};
}

/// Newton's method on the gap to the one feature that is to be met: it falls all the way, so that there is
/// one root between the bounds. Nothing if that does not come to an end.
std::optional<double> ContactSearch::polish(const Disk& disk, double radius, const SureContact& sure,
                                            double time) const
{
  const double earliest = time + sure.earliest;
  const double latest = time + sure.latest;
  double at = std::clamp(time - sure.gap / sure.rate, earliest, latest);
  for (int i = 0; i < MAX_POLISHING; ++i)
  {
    const Approach now = sawtooth_.approach(sure.feature, seenFromBase(disk, motion_.at(at), at), radius);
    if (!(now.rate < 0.0))
      return std::nullopt;
    const double step = -now.gap / now.rate;
    at = std::clamp(at + step, earliest, latest);
    // The next step would be no longer than K step^2 / (2 |rate|).
    if (0.5 * sure.acceleration * step * step <= -now.rate * time_resolution_)
      return at;
  }
  return std::nullopt;
}

/// Whether the disk is out of the base's reach, wherever that is in its oscillation, at both ends of a time:
/// then it is in between, for it falls towards the base: not where that hangs upside down. A comparison,
/// where nearTime() takes a root. May say no where it is.
bool ContactSearch::staysAbove(const Disk& disk, double radius, double from, double until) const
{
  if (search_above_band_ || motion_.turning() || motion_.cosine() <= 0.0 ||
      sawtooth_.boundary() != Boundary::PERIODIC)
    return false;
  const double top = sawtooth_.height() + radius + motion_.displacementBound() * motion_.cosine();
  const auto above = [&](double time)
  {
    const Two place = courseAt(disk, time, gravity_).place;
    return motion_.cosine() * place[1] - motion_.sine() * place[0] > top;
  };
  return above(until) && above(from);
}

/// The first time from `from` on at which the base, wherever it is in its oscillation, could reach
/// the disk: closed form, as long as the base does not turn.
double ContactSearch::nearTime(const Disk& disk, double radius, double from) const
{
  if (search_above_band_ || motion_.turning())
    return from;
  BaseKinematics mount;
  mount.cosine = motion_.cosine();
  mount.sine = motion_.sine();
  const BasePoint p = seenFromBase(disk, mount, from);
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
    bound = (plain + 2.0 * w * speedBound(point) + w * w * (distance + speedBound(point) * span)) /
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
    step.meetLine(feature, a.gap, a.rate, a.normal_s, a.normal_n, [] { return Step::ALWAYS; });
  };
  const auto meet_foot = [&](std::int32_t tooth)
  {
    const BaseFeature feature{BaseFeatureKind::END_FOOT, tooth};
    step.meetPoint(feature, sawtooth_.approach(feature, step.point, step.radius));
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
  const auto meet_slope = [&](const Sawtooth::Slope& slope, BaseFeatureKind kind)
  {
    if (!slope.present)
      return;
    const double ds = s - slope.foot_s;
    const double distance = ds * slope.normal_s + p.n * slope.normal_n;
    const double rate = p.vs * slope.normal_s + p.vn * slope.normal_n;
    // The slope can be met only from in front and between its ends.
    const auto window = [&]
    {
      const double along = ds * slope.along_s + p.n * slope.along_n;
      const double along_rate = p.vs * slope.along_s + p.vn * slope.along_n;
      const double slack = sawtooth_.windowSlack();
      Step::Gap latest{-distance - slack, -rate};
      if (-along - slack > latest.size)
        latest = {-along - slack, -along_rate};
      if (along - slope.length - slack > latest.size)
        latest = {along - slope.length - slack, along_rate};
      return latest;
    };
    step.meetLine({kind, tooth}, distance - step.radius, rate, slope.normal_s, slope.normal_n, window);
  };
  meet_slope(sawtooth_.left(), BaseFeatureKind::LEFT_SLOPE);
  meet_slope(sawtooth_.right(), BaseFeatureKind::RIGHT_SLOPE);
  const BaseFeature apex{BaseFeatureKind::APEX, tooth};
  const double ds = s - sawtooth_.apexOffset();
  const double dn = p.n - sawtooth_.height();
  if (step.canReach(ds * ds + dn * dn))
    step.meetPoint(apex, approachToPoint(ds, dn, p, step.radius));
}

}  // namespace ratchet_sieve
