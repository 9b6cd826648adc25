#pragma once

#include <cstdint>
#include <vector>

#include "model/base_frame.h"
#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The parts of the base that a disk can touch or pass.
enum class BaseFeatureKind : std::int32_t
{
  NONE,
  FACE,        ///< of a tooth
  CORNER,      ///< of a tooth, convex
  END_CORNER,  ///< the top of a wall, or the foot at a free end of the base
  LEFT_WALL,
  RIGHT_WALL,
  LEFT_END,  ///< not a surface: the line s = 0 of an open base or above a wall, behind which the bin is; for
             ///< a periodic base the seam, see BaseShape::seamSlack()
  RIGHT_END  ///< the line s = W
};

/// A part of the base that a disk can touch, or none. Kind and index are in one number of the same width as
/// `tooth`, because both are loaded together, and stores of unequal width would cause a store-forwarding
/// stall.
class BaseFeature
{
public:
  constexpr BaseFeature() = default;

  /// @param tooth of a face or a corner; for END_CORNER 0 or the number of teeth
  /// @param index of the face, or of the corner at its left end, in the outline of a tooth
  constexpr BaseFeature(BaseFeatureKind kind, std::int32_t tooth, std::int32_t index = 0)
      : part_(static_cast<std::int32_t>(kind) | index * (1 << KIND_BITS)), tooth_(tooth)
  {
  }

  constexpr BaseFeatureKind kind() const { return static_cast<BaseFeatureKind>(part_ & KIND_MASK); }
  constexpr std::int32_t index() const { return part_ >> KIND_BITS; }
  constexpr std::int32_t tooth() const { return tooth_; }

  explicit operator bool() const { return part_ != 0; }
  bool isEnd() const { return kind() >= BaseFeatureKind::LEFT_END; }

  void archive(StateArchive& state) { state(part_, tooth_); }

private:
  static constexpr int KIND_BITS = 3;
  static constexpr std::int32_t KIND_MASK = (1 << KIND_BITS) - 1;

  std::int32_t part_ = 0;
  std::int32_t tooth_ = 0;
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

/// The shape of the base, in its own frame: pure geometry, at rest. Every tooth has the same outline of
/// straight faces without overhang. All that is known about a tooth is asked here.
class BaseShape
{
public:
  /// One face, in coordinates of its tooth.
  struct Face
  {
    Eigen::Vector2d foot;    ///< the lower end [m]; of a level face the left one
    Eigen::Vector2d along;   ///< unit vector from the foot to the other end
    Eigen::Vector2d normal;  ///< unit normal, out of the base
    double length;           ///< [m]; 0 for one face of a flat sawtooth of asymmetry 0 or 1
    CollisionKind kind;      ///< of contacts with it: by the sign of its slope
    std::int32_t number;     ///< in the outline, from 0
  };

  /// A corner that a disk can touch: a convex one. In a concave corner a disk touches the two faces.
  struct Corner
  {
    Eigen::Vector2d position;  ///< in coordinates of its tooth [m]
    std::int32_t number;       ///< in the outline, from 0
  };

  /// Consecutive faces and corners of a tooth, which are searched together.
  struct Section
  {
    double start;  ///< s of its first face, in coordinates of the tooth [m]
    const Face *first_face, *end_face;
    const Corner *first_corner, *end_corner;
  };

  /// @param wall_height of a walled base above n = 0 [m]
  BaseShape(const BaseDefinition& base, Boundary boundary, double wall_height = 0.0);
  BaseShape(const BaseShape&) = delete;
  BaseShape& operator=(const BaseShape&) = delete;

  Boundary boundary() const { return boundary_; }
  double width() const { return width_; }
  double toothWidth() const { return tooth_width_; }
  /// Height of the highest corner above n = 0 [m].
  double height() const { return height_; }
  /// From the lowest to the highest corner of a tooth [m].
  double relief() const { return depth_ + height_; }
  /// Depth of the lowest corner below n = 0 [m].
  double depth() const { return depth_; }
  /// Height of the corners at both ends above n = 0 [m]; 0 without walls.
  double wallHeight() const { return wall_height_; }
  const std::vector<Face>& faces() const { return faces_; }        ///< from left to right, by number
  const std::vector<Corner>& corners() const { return corners_; }  ///< from left to right
  std::int32_t teeth() const { return teeth_; }
  double toothStart(std::int32_t tooth) const { return tooth * tooth_width_; }

  /// Whether contacts are counted per face and corner: those of a profile.
  bool isProfile() const { return is_profile_; }

  /// The kind of a contact with a feature that is a surface.
  CollisionKind kindOf(const BaseFeature& feature) const;

  /// The tooth at s. Any integer for a periodic base; otherwise clamped to the existing teeth.
  std::int32_t toothAt(double s) const;

  /// Whether the tooth exists; always true for a periodic base.
  bool hasTooth(std::int32_t tooth) const
  {
    return boundary_ == Boundary::PERIODIC || (tooth >= 0 && tooth < teeth_);
  }

  /// Mean width of a section [m].
  double sectionWidth() const { return section_width_; }

  /// Visits sections from that below s outwards: visit(tooth, section).
  /// @param reachable bool(distance): whether something at this distance from s along the base, or farther,
  /// is still to be visited; < 0 counts as 0
  template <typename Reachable, typename Visit>
  [[gnu::always_inline]] void visitOutwards(double s, Reachable&& reachable, Visit&& visit) const
  {
    const Section* const first = sections_.data();
    const Section* const last = first + sections_.size() - 1;
    const std::int32_t here = toothAt(s);
    std::int32_t tooth = here;
    if (first == last)
    {
      visit(here, *first);
      while (reachable(s - toothStart(tooth)) && hasTooth(--tooth))
        visit(tooth, *first);
      tooth = here;
      while (hasTooth(++tooth) && reachable(toothStart(tooth) - s))
        visit(tooth, *first);
      return;
    }
    const Section* const below = sectionAt(s - toothStart(here));
    visit(here, *below);
    for (const Section* section = below; reachable(s - (toothStart(tooth) + section->start));)
    {
      section = section == first ? last : section - 1;
      if (section == last && !hasTooth(--tooth))
        break;
      visit(tooth, *section);
    }
    tooth = here;
    for (const Section* section = below;;)
    {
      section = section == last ? first : section + 1;
      if (section == first && !hasTooth(++tooth))
        break;
      if (!reachable(toothStart(tooth) + section->start - s))
        break;
      visit(tooth, *section);
    }
  }

  /// Width by which a face extends beyond its ends, so that rounding leaves no gap between neighbouring
  /// faces. Within it, a point is so close to the corner that the error of the gap is at most slack^2 / (2
  /// r).
  double windowSlack() const { return window_slack_; }

  /// Distance by which the ends of a periodic base are outside of [0, W], so that a disk wrapped at one end
  /// is never beyond the other because of rounding [m].
  double seamSlack() const { return boundary_ == Boundary::PERIODIC ? window_slack_ : 0.0; }

  /// The approach of a disk (centre `point`, radius) to a feature.
  Approach approach(const BaseFeature& feature, const BasePoint& point, double radius) const;

  /// Signed distance from a point to the base's surface, > 0 above it.
  double heightAbove(double s, double n) const;

  /// Distance from a point to the nearer wall, < 0 behind it; infinite without walls. For audits and tests.
  double distanceToWalls(double s, double n) const;

private:
  void addFaces();
  void addCorners();
  void addSections();
  const Section* sectionAt(double local) const;
  double surfaceAt(double local) const;

  Boundary boundary_;
  bool is_profile_;
  std::int32_t teeth_;
  double tooth_width_;
  double teeth_per_length_;
  double height_;
  double depth_;  ///< of the lowest corner below n = 0
  double width_;
  double wall_height_;
  double window_slack_;
  double section_width_;
  std::vector<OutlineCorner> outline_;
  std::vector<Face> faces_;
  std::vector<Corner> corners_;
  std::vector<Section> sections_;  ///< at least one
};

}  // namespace ratchet_sieve
