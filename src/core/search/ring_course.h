#pragma once

#include <optional>

#include <Eigen/Core>

#include "model/rotation.h"

namespace ratchet_sieve
{

/// A disk's way past all the images that another has on a ring: they stand in a row, a width apart, and the
/// relative motion is a straight line. So it comes near the row once, and only the images that are there then
/// are tested.
struct RingCourse
{
  Rotation rotation;  ///< by the row's inclination
  double width;       ///< of the ring [m]
  double per_width;   ///< its inverse [1/m]
  int most_laps;      ///< images farther away than this do not count [widths]

  struct Touch
  {
    double time_to_contact;  ///< [s]
    int shift;               ///< of the image that is touched: so many widths to the right
  };

  /// The first touch, if there is one by `horizon` [s].
  /// @param position, velocity of the disk as seen from the other [m, m/s]; @param distance of touching disks
  /// [m]
  std::optional<Touch> firstTouch(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                                  double distance, double horizon) const;
};

}  // namespace ratchet_sieve
