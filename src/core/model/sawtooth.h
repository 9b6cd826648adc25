#pragma once

#include <cstdint>

#include "model/base_frame.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The parts of the base that a disk can touch.
enum class BaseFeatureKind : std::int32_t
{
  NONE,
  LEFT_SLOPE,
  RIGHT_SLOPE,
  APEX,
  END_CORNER,  ///< where an end of the base stands free: the upper end of its wall, or without one the foot
  LEFT_WALL,
  RIGHT_WALL,
  LEFT_END,  ///< not a body: the line s = 0 of an open base or over a wall, behind which the bin lies
  RIGHT_END  ///< the line s = W
};

/// A part of the base that a disk can touch, or none. Its kind is as wide as the tooth: both are
/// loaded together, and stores of unequal width would cause a store-forwarding stall.
struct BaseFeature
{
  BaseFeatureKind kind = BaseFeatureKind::NONE;
  std::int32_t tooth = 0;  ///< for slopes and apices; for END_CORNER 0 or the number of teeth

  explicit operator bool() const { return kind != BaseFeatureKind::NONE; }
  void archive(StateArchive& state) { state(kind, tooth); }
};

/// A disk before one feature of the base.
struct Approach
{
  double gap;   ///< from the disk's rim to the feature, < 0 where they overlap [m]
  double rate;  ///< of change of the gap [m/s]
  Eigen::Vector2d
      normal;  ///< of unit length, from the feature to the disk's centre; in the frame of the base
};

/// @param way from a corner to the disk's centre [m]
inline Approach approachToPoint(const Eigen::Vector2d& way, const BasePoint& point, double radius)
{
  const double distance = way.norm();
  const Eigen::Vector2d normal =
      distance > 0.0 ? Eigen::Vector2d(way / distance) : Eigen::Vector2d(Eigen::Vector2d::UnitY());
  return {distance - radius, normal.dot(point.velocity), normal};
}

/// The shape of the base, in its own frame: pure geometry, at rest.
class Sawtooth
{
public:
  /// One slope, relative to its tooth's left foot.
  struct Slope
  {
    bool present = true;  ///< false where it has no length (h = 0 with a = 0 or 1)
    double foot_s = 0.0;  ///< the lower end, n = 0 [m]
    Eigen::Vector2d along = Eigen::Vector2d::UnitY();   ///< unit vector from foot to apex
    Eigen::Vector2d normal = Eigen::Vector2d::UnitY();  ///< unit normal, out of the base
    double length = 0.0;                                ///< [m]
  };

  /// @param wall_height of a walled base over n = 0 [m]
  Sawtooth(const BaseDefinition& base, Boundary boundary, double wall_height = 0.0);

  Boundary boundary() const { return boundary_; }
  double width() const { return width_; }
  double toothWidth() const { return tooth_width_; }
  double height() const { return height_; }
  /// Of the corners at both ends over n = 0: 0 without walls [m].
  double wallHeight() const { return wall_height_; }
  const Slope& left() const { return left_; }
  const Slope& right() const { return right_; }
  std::int32_t teeth() const { return teeth_; }
  double toothStart(std::int32_t tooth) const { return tooth * tooth_width_; }
  double apexOffset() const { return apex_offset_; }

  /// The tooth over which s lies; on a periodic base any integer, else clamped to the teeth there are.
  std::int32_t toothAt(double s) const;

  /// Whether there is such a tooth: a periodic base never ends.
  bool hasTooth(std::int32_t tooth) const
  {
    return boundary_ == Boundary::PERIODIC || (tooth >= 0 && tooth < teeth_);
  }

  /// A slope's window, widened by this much beyond its ends so that rounding leaves no slit between
  /// neighbours. What lies within it is so near the corner that the gap is off by no more than
  /// slack^2 / (2 r).
  double windowSlack() const { return window_slack_; }

  /// The disk (centre `point`, radius) before a feature.
  Approach approach(const BaseFeature& feature, const BasePoint& point, double radius) const;

  /// Signed distance from a point to the base's surface, > 0 above it. By testing every feature
  /// that could be nearest: for audits and tests.
  double heightAbove(double s, double n) const;

  /// Distance from a point to the nearer wall, < 0 behind it; infinite without walls. For audits and tests.
  double distanceToWalls(double s, double n) const;

private:
  Boundary boundary_;
  std::int32_t teeth_;
  double tooth_width_;
  double teeth_per_length_;
  double height_;
  double width_;
  double wall_height_;
  double apex_offset_;
  double window_slack_;
  Slope left_;
  Slope right_;
};

}  // namespace ratchet_sieve
