#include "model/sawtooth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ratchet_sieve
{
namespace
{
/// Width by which slopes extend beyond their ends, in resolutions of the farthest position; see
/// Sawtooth::windowSlack().
constexpr double WINDOW_SLACK = 64.0 * std::numeric_limits<double>::epsilon();

Sawtooth::Slope makeSlope(double foot_s, double apex_s, double height, double outward_sign)
{
  Sawtooth::Slope slope;
  slope.foot_s = foot_s;
  slope.length = std::sqrt((apex_s - foot_s) * (apex_s - foot_s) + height * height);
  slope.present = slope.length > 0.0;
  if (!slope.present)
    return slope;
  slope.along = {(apex_s - foot_s) / slope.length, height / slope.length};
  slope.normal = {-outward_sign * slope.along.y(), outward_sign * slope.along.x()};
  return slope;
}

Approach approachToLine(double distance, const Eigen::Vector2d& normal, const BasePoint& point, double radius)
{
  return {distance - radius, normal.dot(point.velocity), normal};
}

double distanceToSlope(const Sawtooth::Slope& slope, double s, double n)
{
  const Eigen::Vector2d from_foot(s - slope.foot_s, n);
  const double along = std::clamp(from_foot.dot(slope.along), 0.0, slope.length);
  return (from_foot - along * slope.along).norm();
}
}  // namespace

Sawtooth::Sawtooth(const BaseDefinition& base, Boundary boundary, double wall_height)
    : boundary_(boundary),
      teeth_(base.teeth),
      tooth_width_(base.tooth_width),
      teeth_per_length_(1.0 / base.tooth_width),
      height_(base.tooth_height),
      width_(base.width()),
      wall_height_(boundary == Boundary::WALLED ? wall_height : 0.0),
      apex_offset_(base.asymmetry * base.tooth_width),
      window_slack_(WINDOW_SLACK * std::max(width_, height_)),
      left_(makeSlope(0.0, apex_offset_, base.tooth_height, 1.0)),
      right_(makeSlope(base.tooth_width, apex_offset_, base.tooth_height, -1.0))
{
}

std::int32_t Sawtooth::toothAt(double s) const
{
  double tooth = std::floor(s * teeth_per_length_);
  if (boundary_ != Boundary::PERIODIC)
    tooth = std::clamp(tooth, 0.0, teeth_ - 1.0);
  return static_cast<std::int32_t>(tooth);
}

Approach Sawtooth::approach(const BaseFeature& feature, const BasePoint& point, double radius) const
{
  const double s = point.s() - toothStart(feature.tooth);
  switch (feature.kind)
  {
    case BaseFeatureKind::LEFT_SLOPE:
    case BaseFeatureKind::RIGHT_SLOPE:
    {
      const Slope& slope = feature.kind == BaseFeatureKind::LEFT_SLOPE ? left_ : right_;
      const double distance = Eigen::Vector2d(s - slope.foot_s, point.n()).dot(slope.normal);
      return approachToLine(distance, slope.normal, point, radius);
    }
    case BaseFeatureKind::APEX:
      return approachToPoint({s - apex_offset_, point.n() - height_}, point, radius);
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

double Sawtooth::heightAbove(double s, double n) const
{
  // Far below the base, only the depth is needed.
  if (n < -(height_ + tooth_width_))
    return n;
  const std::int32_t here = toothAt(s);
  const double local = s - toothStart(here);
  const double surface = local < apex_offset_ ? height_ * local / apex_offset_
                         : tooth_width_ > apex_offset_
                             ? height_ * (tooth_width_ - local) / (tooth_width_ - apex_offset_)
                             : height_;
  const auto reach = static_cast<std::int32_t>(std::ceil((std::abs(n) + height_) / tooth_width_)) + 1;
  const std::int32_t limit = boundary_ == Boundary::PERIODIC ? reach : std::min(reach, teeth_);
  double nearest = std::abs(n) + height_ + tooth_width_;
  for (std::int32_t tooth = here - limit; tooth <= here + limit; ++tooth)
    for (const Slope* slope : {&left_, &right_})
      if (slope->present && hasTooth(tooth))
        nearest = std::min(nearest, distanceToSlope(*slope, s - toothStart(tooth), n));
  return n < surface ? -nearest : nearest;
}

double Sawtooth::distanceToWalls(double s, double n) const
{
  if (boundary_ != Boundary::WALLED)
    return std::numeric_limits<double>::infinity();
  const double beside = std::min(s, width_ - s);
  const double above = n - wall_height_;
  return above <= 0.0 ? beside : std::sqrt(beside * beside + above * above);
}

}  // namespace ratchet_sieve
