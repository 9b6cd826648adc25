#include "ratchet_sieve/core/sawtooth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ratchet_sieve
{
namespace
{
/// By how many resolutions of the farthest place slopes reach beyond their ends; see
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
  slope.along_s = (apex_s - foot_s) / slope.length;
  slope.along_n = height / slope.length;
  slope.normal_s = -outward_sign * slope.along_n;
  slope.normal_n = outward_sign * slope.along_s;
  return slope;
}

Approach approachToLine(double distance, double normal_s, double normal_n, const BasePoint& point,
                        double radius)
{
  return {distance - radius, normal_s * point.vs + normal_n * point.vn, normal_s, normal_n};
}

double distanceToSlope(const Sawtooth::Slope& slope, double s, double n)
{
  const double along = std::clamp((s - slope.foot_s) * slope.along_s + n * slope.along_n, 0.0, slope.length);
  const double ds = s - slope.foot_s - along * slope.along_s;
  const double dn = n - along * slope.along_n;
  return std::sqrt(ds * ds + dn * dn);
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
  const double s = point.s - toothStart(feature.tooth);
  switch (feature.kind)
  {
    case BaseFeatureKind::LEFT_SLOPE:
    case BaseFeatureKind::RIGHT_SLOPE:
    {
      const Slope& slope = feature.kind == BaseFeatureKind::LEFT_SLOPE ? left_ : right_;
      const double distance = (s - slope.foot_s) * slope.normal_s + point.n * slope.normal_n;
      return approachToLine(distance, slope.normal_s, slope.normal_n, point, radius);
    }
    case BaseFeatureKind::APEX:
      return approachToPoint(s - apex_offset_, point.n - height_, point, radius);
    case BaseFeatureKind::END_CORNER:
      return approachToPoint(s, point.n - wall_height_, point, radius);
    case BaseFeatureKind::LEFT_WALL:
      return approachToLine(point.s, 1.0, 0.0, point, radius);
    case BaseFeatureKind::RIGHT_WALL:
      return approachToLine(width_ - point.s, -1.0, 0.0, point, radius);
    case BaseFeatureKind::LEFT_END:
      return approachToLine(point.s, 1.0, 0.0, point, 0.0);
    case BaseFeatureKind::RIGHT_END:
    case BaseFeatureKind::NONE:
      break;
  }
  return approachToLine(width_ - point.s, -1.0, 0.0, point, 0.0);
}

double Sawtooth::heightAbove(double s, double n) const
{
  // Far below, all that is asked is how deep.
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
