#pragma once

#include <algorithm>
#include <optional>

#include "model/sawtooth.h"
#include "ratchet_sieve/core/numbers.h"

namespace ratchet_sieve
{

/// Tests whether a disk may overlap the base or be beyond one of its ends. Uses the two slopes of the valley
/// below the disk, each extended to a line. The line contains the slope's apex, so no overlap is missed.
class BaseOverlap
{
public:
  explicit BaseOverlap(const Sawtooth& sawtooth)
      : height_(sawtooth.height()),
        wall_(sawtooth.boundary() == Boundary::WALLED),
        periodic_(sawtooth.boundary() == Boundary::PERIODIC),
        width_(sawtooth.width()),
        tooth_width_(sawtooth.toothWidth()),
        teeth_per_length_(1.0 / sawtooth.toothWidth()),
        apex_(sawtooth.apexOffset()),
        to_the_right_(sawtooth.left().normal),
        to_the_left_(sawtooth.right().normal)
  {
  }

  /// @param s, n of the disk's centre in the frame of the base [m]
  bool overlaps(double s, double n, double radius) const
  {
    if (!periodic_ && beyondEnds(s, wall_ ? radius : 0.0))
      return true;
    if (n >= height_ + radius)
      return false;
    const Valley valley = valleyBelow(s, n);
    return (valley.to_left < radius) | (valley.to_right < radius);
  }

  /// The distance by which a disk whose centre is below the surface must be raised, normal to the base, to be
  /// free of both slopes [m]; nothing if its centre is above.
  std::optional<double> wayOut(double s, double n, double radius) const
  {
    const Valley valley = valleyBelow(s, n);
    if (n >= height_ || std::min(valley.to_left, valley.to_right) >= 0.0 ||
        (!periodic_ && beyondEnds(s, 0.0)))
      return std::nullopt;
    const double over_apices = height_ + radius - n;
    const auto over = [&](double distance, const Eigen::Vector2d& normal)
    { return normal.y() > 0.0 ? (radius - distance) / normal.y() : over_apices; };
    return std::min(over_apices,
                    std::max(over(valley.to_left, to_the_left_), over(valley.to_right, to_the_right_)));
  }

private:
  /// Signed distances of a point from the lines of the two slopes of the valley below it, < 0 behind a line
  /// [m].
  struct Valley
  {
    double to_left;
    double to_right;
  };

  Valley valleyBelow(double s, double n) const
  {
    const double from_foot = s - floored((s - apex_) * teeth_per_length_ + 1.0) * tooth_width_;
    return {from_foot * to_the_left_.x() + n * to_the_left_.y(),
            from_foot * to_the_right_.x() + n * to_the_right_.y()};
  }

  bool beyondEnds(double s, double margin) const { return s < margin || s > width_ - margin; }

  double height_;
  bool wall_;
  bool periodic_;
  double width_;
  double tooth_width_;
  double teeth_per_length_;
  double apex_;
  Eigen::Vector2d to_the_right_;  ///< normal of the slope on the right of a valley
  Eigen::Vector2d to_the_left_;   ///< normal of the slope on the left of a valley
};

}  // namespace ratchet_sieve
