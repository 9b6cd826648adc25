#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "model/base_shape.h"
#include "ratchet_sieve/core/numbers.h"

namespace ratchet_sieve
{

/// Tests whether a disk may overlap the base or be beyond one of its ends. Between two neighbouring corners
/// the base is a *pocket*: the space above it is convex, and a disk is in it if it is in front of the lines
/// of all its faces. Every line contains the corner at its end. So no overlap is missed where all corners are
/// as high as the highest; elsewhere the distance to the base is computed.
class BaseOverlap
{
public:
  explicit BaseOverlap(const BaseShape& shape);

  /// @param s, n of the disk's centre in the frame of the base [m]
  bool overlaps(double s, double n, double radius) const
  {
    if (!periodic_ && beyondEnds(s, wall_ ? radius : 0.0))
      return true;
    if (n >= height_ + radius)
      return false;
    if (is_valley_)
    {
      const double from_foot = inPockets(s);
      return (lines_[0].distance(from_foot, n) < radius) | (lines_[1].distance(from_foot, n) < radius);
    }
    if (!even_)
      return shape_.heightAbove(s, n) < radius;
    const double local = inPockets(s);
    const Pocket& pocket = pocketAt(local);
    bool overlaps = false;
    for (const Line* line = pocket.begin; line != pocket.end; ++line)
      overlaps |= line->distance(local, n) < radius;
    return overlaps;
  }

  /// The distance by which a disk whose centre is below the surface must be raised, normal to the base, to be
  /// free of the faces of its pocket [m]; nothing if its centre is above.
  std::optional<double> wayOut(double s, double n, double radius) const;

  /// A disk that moves no farther than this within a step passes no ridge of the base without an overlap at
  /// the end of the step [m].
  double shortestPassage(double radius) const { return is_valley_ ? height_ : 2.0 * radius; }

private:
  /// A face, extended to a line, in coordinates in which the pockets of a tooth are one after another.
  struct Line
  {
    Eigen::Vector2d normal;
    double offset;  ///< of the line from the origin, along the normal [m]

    /// Signed distance of a point, < 0 behind the line [m].
    double distance(double s, double n) const { return s * normal.x() + n * normal.y() - offset; }
  };
  struct Pocket
  {
    double start;  ///< s of its left corner
    const Line* begin;
    const Line* end;
  };

  /// s in the coordinates of the pockets.
  double inPockets(double s) const
  {
    return s - floored((s - first_corner_) * teeth_per_length_ + 1.0) * tooth_width_;
  }

  const Pocket& pocketAt(double local) const
  {
    const auto starts_behind = [](double s, const Pocket& pocket) { return s < pocket.start; };
    return pockets_.size() == 1
               ? pockets_.front()
               : *(std::upper_bound(pockets_.begin() + 1, pockets_.end(), local, starts_behind) - 1);
  }

  bool beyondEnds(double s, double margin) const { return s < margin || s > width_ - margin; }

  const BaseShape& shape_;
  double height_;
  bool wall_;
  bool periodic_;
  bool even_;       ///< all corners are as high as the highest
  bool is_valley_;  ///< a tooth has one pocket, of two faces with the foot at s = 0, n = 0
  double width_;
  double tooth_width_;
  double teeth_per_length_;
  double first_corner_;  ///< s of the first corner of a tooth; its pocket ends there [m]
  std::vector<Line> lines_;
  std::vector<Pocket> pockets_;
};

}  // namespace ratchet_sieve
