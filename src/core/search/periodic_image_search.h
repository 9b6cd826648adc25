#pragma once

#include <optional>

#include <Eigen/Core>

#include "model/motion.h"

namespace ratchet_sieve
{

/// Finds the first contact of a disk with the images of another on a ring. The images form a row, one width
/// apart, and the relative motion is a straight line. So the disk comes near the row once, and only the
/// images near that place are tested.
struct PeriodicImageSearch
{
  Rotation rotation;  ///< by the row's inclination
  double width;       ///< of the ring [m]
  double per_width;   ///< its inverse [1/m]
  int most_laps;      ///< images further away are ignored [widths]

  struct Touch
  {
    double time_to_contact;  ///< [s]
    int shift;               ///< image that is touched, in widths to the right
  };

  /// The first contact, if there is one by `horizon` [s].
  /// @param position, velocity of the disk relative to the other [m, m/s]; @param distance at contact [m]
  std::optional<Touch> firstTouch(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                                  double distance, double horizon) const;
};

}  // namespace ratchet_sieve
