#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "search/contact_search.h"
#include "search/quadratic.h"

namespace ratchet_sieve
{
constexpr double INFINITE_TIME = std::numeric_limits<double>::infinity();

/// No less than the speed: where only a bound is needed, that saves the root.
inline double speedBound(const BasePoint& point)
{
  return point.velocity.lpNorm<1>();
}

/// How a disk is accelerated as seen from the base, over the bound on that: up or down in the world, and
/// sideways; anyhow while the base turns.
struct ContactSearch::Direction
{
  bool any = true;
  Eigen::Vector2d upright = Eigen::Vector2d::Zero();   ///< of length 1 where there is nothing sideways
  Eigen::Vector2d sideways = Eigen::Vector2d::Zero();  ///< at right angles to it
  bool oblique = false;                                ///< whether there is anything sideways

  /// How much of it shows along a unit normal at most.
  double share(const Eigen::Vector2d& normal) const
  {
    if (any)
      return 1.0;
    const double share = std::abs(upright.dot(normal));
    return oblique ? std::min(1.0, share + std::abs(sideways.dot(normal))) : share;
  }
};

/// One step of the search: the disk as it is, the shortest time any feature guarantees, and whether one
/// feature is certain to be hit before any other.
class ContactSearch::Step
{
public:
  /// @param acceleration bounds the relative one; it points as `forced` has it
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
  void limitTo(double distance)
  {
    if (reach_ <= distance)
      return;
    free_time_ = horizon_ = others_free_time_ = guaranteedFreeTime(distance, -speed_, acceleration_);
    updateReach();
  }

  /// A slope or a wall, in contact where `gap` is 0; the further condition of a slope is the `window`.
  /// @param normal of the line
  template <typename FindWindow>
  [[gnu::always_inline]] void testLine(const BaseFeature& feature, double gap, double rate,
                                       const Eigen::Vector2d& normal, FindWindow&& find_window)
  {
    // How fast the distance to the line can be accelerated.
    const double acceleration = acceleration_ * forced_.share(normal);
    if (!staysFree(gap, rate, acceleration))
      test(feature, {gap, rate}, acceleration, acceleration, find_window());
  }

  /// A corner. The distance to it is accelerated whatever its direction, and by passing, too.
  void testPoint(const BaseFeature& feature, const Approach& approach)
  {
    if (staysFree(approach.gap, approach.rate, acceleration_))
      return;
    const double top_speed = speed_ + acceleration_ * horizon_;
    const double parting = acceleration_ + top_speed * top_speed / radius;
    test(feature, {approach.gap, approach.rate}, acceleration_, parting, ALWAYS);
  }

  bool canReach(double distance_squared) const
  {
    const double reach = reach_ + radius;
    return distance_squared <= reach * reach;
  }

  /// Whether the disk is higher over the base than this all through the step.
  bool staysOver(double height) const
  {
    return staysFree(point.n() - height - radius, point.velocity.y(), acceleration_);
  }

  /// Whether no part of the disk comes higher than this in the step.
  bool staysBelow(double height) const { return point.n() + radius + reach_ < height; }

  double freeTime() const { return std::max(free_time_, resolution_); }

  /// What the disk touches now.
  const BaseFeature& contact() const { return contact_; }

  /// What the disk will hit for certain, and before anything else.
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
  /// A feature in contact where `gap` is 0 while `window` holds (window <= 0). Each of the
  /// two alone keeps the disk free, so the longer guarantee counts.
  /// @param approaching, parting bound the gap's acceleration towards the feature and away from it
  // Called from several points: left to itself, the compiler would call it for the teeth, too, at 1 % of a
  // run.
  [[gnu::always_inline]] void test(const BaseFeature& feature, const Gap& gap, double approaching,
                                   double parting, const Gap& window)
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

  /// Whether a gap stays open through the step: a comparison, where the time itself takes a root.
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
  BaseFeature contact_;
  double contact_gap_ = 0.0;
  SureContact sure_;
};

}  // namespace ratchet_sieve
