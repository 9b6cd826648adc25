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
  END_CORNER,  ///< the top of a wall, or the foot at a free end of the base
  LEFT_WALL,
  RIGHT_WALL,
  LEFT_END,  ///< not a surface: the line s = 0 of an open base or above a wall, behind which the bin is; for
             ///< a periodic base the seam, see Sawtooth::seamSlack()
  RIGHT_END  ///< the line s = W
};

/// A part of the base that a disk can touch, or none. The kind has the same width as `tooth`, because both
/// are loaded together, and stores of unequal width would cause a store-forwarding stall.
struct BaseFeature
{
  BaseFeatureKind kind = BaseFeatureKind::NONE;
  std::int32_t tooth = 0;  ///< for slopes and apices; for END_CORNER 0 or the number of teeth

  explicit operator bool() const { return kind != BaseFeatureKind::NONE; }
  bool isEnd() const { return kind == BaseFeatureKind::LEFT_END || kind == BaseFeatureKind::RIGHT_END; }
  void archive(StateArchive& state)
  {
    /// Bound on the number of teeth, and on the index of the tooth under a disk many widths away from a
    /// periodic base.
    constexpr std::int32_t FARTHEST_TOOTH = 1 << 30;
    state(kind, tooth);
    state.require(kind >= BaseFeatureKind::NONE && kind <= BaseFeatureKind::RIGHT_END &&
                      tooth >= -FARTHEST_TOOTH && tooth <= FARTHEST_TOOTH,
                  "a disk's contact is with an unknown part of the base");
  }
};

/// The distance of a disk from one feature of the base.
struct Approach
{
  double gap;   ///< from the disk's rim to the feature, < 0 if they overlap [m]
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
  /// One slope, in coordinates of its tooth with the origin at the left foot.
  struct Slope
  {
    bool present = true;  ///< false for a slope of length 0 (h = 0 with a = 0 or 1)
    double foot_s = 0.0;  ///< the lower end, n = 0 [m]
    Eigen::Vector2d along = Eigen::Vector2d::UnitY();   ///< unit vector from foot to apex
    Eigen::Vector2d normal = Eigen::Vector2d::UnitY();  ///< unit normal, out of the base
    double length = 0.0;                                ///< [m]
  };

  /// @param wall_height of a walled base above n = 0 [m]
  Sawtooth(const BaseDefinition& base, Boundary boundary, double wall_height = 0.0);

  Boundary boundary() const { return boundary_; }
  double width() const { return width_; }
  double toothWidth() const { return tooth_width_; }
  double height() const { return height_; }
  /// Height of the corners at both ends above n = 0 [m]; 0 without walls.
  double wallHeight() const { return wall_height_; }
  const Slope& left() const { return left_; }
  const Slope& right() const { return right_; }
  std::int32_t teeth() const { return teeth_; }
  double toothStart(std::int32_t tooth) const { return tooth * tooth_width_; }
  double apexOffset() const { return apex_offset_; }

  /// The tooth at s. Any integer for a periodic base; otherwise clamped to the existing teeth.
  std::int32_t toothAt(double s) const;

  /// Whether the tooth exists; always true for a periodic base.
  bool hasTooth(std::int32_t tooth) const
  {
    return boundary_ == Boundary::PERIODIC || (tooth >= 0 && tooth < teeth_);
  }

  /// Width by which a slope extends beyond its ends, so that rounding leaves no gap between neighbouring
  /// slopes. Within it, a point is so close to the corner that the error of the gap is at most slack^2 / (2
  /// r).
  double windowSlack() const { return window_slack_; }

  /// Distance by which the ends of a periodic base are outside of [0, W], so that a disk wrapped at one end
  /// is never beyond the other because of rounding [m].
  double seamSlack() const { return boundary_ == Boundary::PERIODIC ? window_slack_ : 0.0; }

  /// The approach of a disk (centre `point`, radius) to a feature.
  Approach approach(const BaseFeature& feature, const BasePoint& point, double radius) const;

  /// Signed distance from a point to the base's surface, > 0 above it. Tests every feature that could be
  /// nearest; for audits and tests.
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
