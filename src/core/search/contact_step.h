#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "search/contact_search.h"

namespace ratchet_sieve
{
constexpr double INFINITE_TIME = std::numeric_limits<double>::infinity();

/// An upper bound of the speed, which avoids a square root.
inline double speedBound(const BasePoint& point)
{
  return point.velocity.lpNorm<1>();
}

/// The direction of a disk's acceleration relative to the base, each part as a fraction of its bound:
/// vertical in the world, and sideways. Any direction while the base turns.
struct ContactSearch::Direction
{
  bool any = true;
  Eigen::Vector2d upright = Eigen::Vector2d::Zero();   ///< of length 1 if there is no sideways part
  Eigen::Vector2d sideways = Eigen::Vector2d::Zero();  ///< at right angles to it
  bool oblique = false;                                ///< whether there is a sideways part

  /// Largest component along a unit normal.
  double share(const Eigen::Vector2d& normal) const
  {
    if (any)
      return 1.0;
    const double share = std::abs(upright.dot(normal));
    return oblique ? std::min(1.0, share + std::abs(sideways.dot(normal))) : share;
  }
};

/// One step of the search: the disk's present state, the shortest time guaranteed by any feature, and whether
/// one feature is certain to be hit before any other.
class ContactSearch::Step
{
public:
  /// @param acceleration bound on the relative acceleration, in the directions of `forced`
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

  /// Limits the step so that nothing beyond this distance can be reached.
  void limitTo(double distance)
  {
    if (reach_ <= distance)
      return;
    free_time_ = horizon_ = others_free_time_ = guaranteedFreeTime(distance, -speed_, acceleration_);
    updateReach();
  }

  /// A slope or a wall, in contact when `gap` is 0. A slope has the further condition `window`.
  /// @param normal of the line
  template <typename FindWindow>
  [[gnu::always_inline]] void testLine(const BaseFeature& feature, double gap, double rate,
                                       const Eigen::Vector2d& normal, FindWindow&& find_window)
  {
    // Most lines are out of reach whatever the direction of the acceleration.
    if (staysFree(gap, rate))
      return;
    // Bound on the acceleration along the normal of the line.
    const double acceleration = acceleration_ * forced_.share(normal);
    if (!staysFree(gap, rate, acceleration))
      test(feature, {gap, rate}, acceleration, acceleration, find_window());
  }

  /// A corner. The full acceleration counts in any direction, and so does the sideways motion past the
  /// corner.
  void testPoint(const BaseFeature& feature, const Approach& approach)
  {
    if (staysFree(approach.gap, approach.rate))
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

  /// Whether the disk is above this height over the base throughout the step.
  bool staysOver(double height) const { return staysFree(point.n() - height - radius, point.velocity.y()); }

  /// Whether no part of the disk is above this height in the step.
  bool staysBelow(double height) const { return point.n() + radius + reach_ < height; }

  double freeTime() const { return std::max(free_time_, resolution_); }

  /// The feature that the disk touches now.
  const BaseFeature& contact() const { return contact_; }

  /// The feature that is certain to be hit first.
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
  [[gnu::always_inline]] void test(const BaseFeature& feature, const Gap& gap, double approaching,
                                   double parting, const Gap& window)
  {
    if (staysFree(window.size, window.rate))
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

  /// The latest possible time of contact for a decreasing gap, while the window stays open; otherwise never.
  double latestContact(const Gap& gap, double parting, const Gap& window) const
  {
    const double discriminant = gap.rate * gap.rate - 2.0 * parting * gap.size;
    if (gap.rate >= 0.0 || gap.size <= 0.0 || discriminant <= 0.0)
      return INFINITE_TIME;
    const double latest = 2.0 * gap.size / (std::sqrt(discriminant) - gap.rate);
    const bool stays_open = window.size + (speed_ + 0.5 * acceleration_ * latest) * latest <= 0.0;
    return stays_open ? latest : INFINITE_TIME;
  }

  void updateReach()
  {
    reach_ = (speed_ + 0.5 * acceleration_ * horizon_) * horizon_;
    span_ = std::max(horizon_, resolution_);
    loss_ = 0.5 * acceleration_ * span_;
  }

  /// Whether a gap stays positive throughout the step: a comparison, where the time itself needs a root.
  bool staysFree(double gap, double rate, double acceleration) const
  {
    return gap > 0.0 && gap + (rate - 0.5 * acceleration * span_) * span_ > 0.0;
  }

  /// The same with the bound of the acceleration in any direction.
  bool staysFree(double gap, double rate) const { return gap > 0.0 && gap + (rate - loss_) * span_ > 0.0; }

  const Direction& forced_;
  double acceleration_;
  double resolution_;
  double free_time_;
  double horizon_;           ///< later times are irrelevant
  double others_free_time_;  ///< guaranteed by all features except the sure one
  double speed_;
  double span_ = 0.0;   ///< the horizon, at least the resolution
  double loss_ = 0.0;   ///< of a gap's rate over the span, half of it [m/s]
  double reach_ = 0.0;  ///< distance within which a feature can be reached before the horizon
  BaseFeature contact_;
  double contact_gap_ = 0.0;
  SureContact sure_;
};

}  // namespace ratchet_sieve
