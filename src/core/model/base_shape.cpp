#include "model/base_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ratchet_sieve
{
namespace
{
/// Width by which faces extend beyond their ends, in resolutions of the farthest position; see
/// BaseShape::windowSlack().
constexpr double WINDOW_SLACK = 64.0 * std::numeric_limits<double>::epsilon();

/// Sine of the smallest turn of the outline that is a corner: the extended faces cover a smaller one.
constexpr double SMALLEST_TURN = 8.0 * std::numeric_limits<double>::epsilon();

/// Faces of a section. More of them are tested in vain; fewer take longer to step over.
constexpr std::size_t SECTION_FACES = 2;

/// @param outward_sign 1 for a foot at the left end, -1 at the right end
BaseShape::Face makeFace(const OutlineCorner& foot, const OutlineCorner& top, double outward_sign)
{
  BaseShape::Face face;
  const Eigen::Vector2d way(top.s - foot.s, top.n - foot.n);
  face.foot = {foot.s, foot.n};
  face.along = face.normal = Eigen::Vector2d::UnitY();
  face.length = std::sqrt(way.x() * way.x() + way.y() * way.y());
  if (face.length == 0.0)
    return face;
  face.along = {way.x() / face.length, way.y() / face.length};
  face.normal = {-outward_sign * face.along.y(), outward_sign * face.along.x()};
  return face;
}

Approach approachToLine(double distance, const Eigen::Vector2d& normal, const BasePoint& point, double radius)
{
  return {distance - radius, normal.dot(point.velocity), normal};
}

double distanceToFace(const BaseShape::Face& face, double s, double n)
{
  const Eigen::Vector2d from_foot(s - face.foot.x(), n - face.foot.y());
  const double along = std::clamp(from_foot.dot(face.along), 0.0, face.length);
  return (from_foot - along * face.along).norm();
}

/// The component of `to` across `from`: the sine of the turn, > 0 to the left.
double turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  return from.x() * to.y() - from.y() * to.x();
}

/// The direction of a face from left to right.
Eigen::Vector2d toTheRight(const BaseShape::Face& face)
{
  return {face.normal.y(), -face.normal.x()};
}
}  // namespace

BaseShape::BaseShape(const BaseDefinition& base, Boundary boundary, double wall_height)
    : boundary_(boundary),
      is_profile_(!base.isSawtooth()),
      teeth_(base.teeth),
      tooth_width_(base.toothWidth()),
      teeth_per_length_(1.0 / tooth_width_),
      height_(base.highest()),
      depth_(base.depth()),
      width_(base.width()),
      wall_height_(boundary == Boundary::WALLED ? wall_height : 0.0),
      window_slack_(WINDOW_SLACK * std::max({width_, height_, depth_})),
      outline_(base.outline())
{
  addFaces();
  addCorners();
  addSections();
}

void BaseShape::addFaces()
{
  for (std::size_t i = 0; i + 1 < outline_.size(); ++i)
  {
    const OutlineCorner& left = outline_[i];
    const OutlineCorner& right = outline_[i + 1];
    const bool rises = left.n <= right.n;
    Face face = rises ? makeFace(left, right, 1.0) : makeFace(right, left, -1.0);
    face.kind = left.n == right.n ? CollisionKind::LEVEL
                : rises           ? CollisionKind::LEFT_SLOPE
                                  : CollisionKind::RIGHT_SLOPE;
    face.number = static_cast<std::int32_t>(i);
    faces_.push_back(face);
  }
}

void BaseShape::addCorners()
{
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    const Face& before = faces_[(i > 0 ? i : faces_.size()) - 1];
    if (turn(toTheRight(before), toTheRight(faces_[i])) < -SMALLEST_TURN)
      corners_.push_back({{outline_[i].s, outline_[i].n}, faces_[i].number});
  }
}

void BaseShape::addSections()
{
  const Corner* corner = corners_.data();
  const Corner* const last_corner = corner + corners_.size();
  for (std::size_t first = 0; first < faces_.size(); first += SECTION_FACES)
  {
    const std::size_t end = std::min(first + SECTION_FACES, faces_.size());
    Section section{outline_[first].s, faces_.data() + first, faces_.data() + end, corner, corner};
    while (section.end_corner != last_corner && section.end_corner->number < static_cast<std::int32_t>(end))
      ++section.end_corner;
    corner = section.end_corner;
    sections_.push_back(section);
  }
  if (faces_.front().length == 0.0)
    ++sections_.front().first_face;
  if (faces_.back().length == 0.0)
    --sections_.back().end_face;
  section_width_ = tooth_width_ / static_cast<double>(sections_.size());
}

CollisionKind BaseShape::kindOf(const BaseFeature& feature) const
{
  switch (feature.kind())
  {
    case BaseFeatureKind::FACE:
      return faces_[static_cast<std::size_t>(feature.index())].kind;
    case BaseFeatureKind::LEFT_WALL:
    case BaseFeatureKind::RIGHT_WALL:
      return CollisionKind::WALL;
    case BaseFeatureKind::END_CORNER:
      return boundary_ == Boundary::WALLED ? CollisionKind::WALL : CollisionKind::APEX;
    default:
      return CollisionKind::APEX;
  }
}

std::int32_t BaseShape::toothAt(double s) const
{
  double tooth = std::floor(s * teeth_per_length_);
  if (boundary_ != Boundary::PERIODIC)
    tooth = std::clamp(tooth, 0.0, teeth_ - 1.0);
  return static_cast<std::int32_t>(tooth);
}

/// @param local in coordinates of the tooth; outside of it the section at its end
const BaseShape::Section* BaseShape::sectionAt(double local) const
{
  const auto above = std::upper_bound(sections_.begin() + 1, sections_.end(), local,
                                      [](double s, const Section& section) { return s < section.start; });
  return &*(above - 1);
}

Approach BaseShape::approach(const BaseFeature& feature, const BasePoint& point, double radius) const
{
  const double s = point.s() - toothStart(feature.tooth());
  const auto index = static_cast<std::size_t>(feature.index());
  switch (feature.kind())
  {
    case BaseFeatureKind::FACE:
    {
      const Face& face = faces_[index];
      const double distance = Eigen::Vector2d(s - face.foot.x(), point.n() - face.foot.y()).dot(face.normal);
      return approachToLine(distance, face.normal, point, radius);
    }
    case BaseFeatureKind::CORNER:
    {
      const OutlineCorner& corner = outline_[index];
      return approachToPoint({s - corner.s, point.n() - corner.n}, point, radius);
    }
    case BaseFeatureKind::END_CORNER:
      return approachToPoint({s, point.n() - wall_height_}, point, radius);
    case BaseFeatureKind::LEFT_WALL:
      return approachToLine(point.s(), Eigen::Vector2d::UnitX(), point, radius);
    case BaseFeatureKind::RIGHT_WALL:
      return approachToLine(width_ - point.s(), -Eigen::Vector2d::UnitX(), point, radius);
    case BaseFeatureKind::LEFT_END:
      return approachToLine(point.s() + seamSlack(), Eigen::Vector2d::UnitX(), point, 0.0);
    case BaseFeatureKind::RIGHT_END:
    case BaseFeatureKind::NONE:
      break;
  }
  return approachToLine(width_ - point.s() + seamSlack(), -Eigen::Vector2d::UnitX(), point, 0.0);
}

/// Height of the surface at a place that is no vertical face [m].
/// @param local in coordinates of the tooth; outside of it the last face is extended
double BaseShape::surfaceAt(double local) const
{
  const Section& section = *sectionAt(local);
  double surface = height_;
  for (const Face* face = section.first_face; face != section.end_face; ++face)
  {
    if (face != section.first_face && local < outline_[static_cast<std::size_t>(face->number)].s)
      break;
    const double beside = std::abs(local - face->foot.x());
    surface = face->foot.y() +
              (face->along.x() != 0.0 ? beside * face->along.y() / std::abs(face->along.x()) : face->length);
  }
  return surface;
}

double BaseShape::heightAbove(double s, double n) const
{
  // Far below the base, only the depth is needed.
  if (n < -(relief() + tooth_width_))
    return n;
  double nearest = std::abs(n) + relief() + tooth_width_;
  visitOutwards(
      s, [&](double beside) { return beside <= nearest; },
      [&](std::int32_t tooth, const Section& section)
      {
        for (const Face* face = section.first_face; face != section.end_face; ++face)
          nearest = std::min(nearest, distanceToFace(*face, s - toothStart(tooth), n));
      });
  return n < surfaceAt(s - toothStart(toothAt(s))) ? -nearest : nearest;
}

double BaseShape::distanceToWalls(double s, double n) const
{
  if (boundary_ != Boundary::WALLED)
    return std::numeric_limits<double>::infinity();
  const double beside = std::min(s, width_ - s);
  const double above = n - wall_height_;
  return above <= 0.0 ? beside : std::sqrt(beside * beside + above * above);
}

}  // namespace ratchet_sieve
