#pragma once

#include <Eigen/Core>

#include "model/disk.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Position and velocity of a point in the frame of the base: (s, n), s along the base, n normal to it.
struct BasePoint
{
  Eigen::Vector2d position;  ///< [m]
  Eigen::Vector2d velocity;  ///< relative to the base at that point [m/s]

  double s() const { return position.x(); }
  double n() const { return position.y(); }
};

/// The shift to a periodic image of a disk, along the base. World frame.
struct Image
{
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d velocity =
      Eigen::Vector2d::Zero();  ///< velocity of the shift; nonzero only while the base turns [m/s]
};

/// The frame of the base at an instant: its origin, the foot s = 0, n = 0, is at D in the world, and the base
/// is inclined about it by theta. The rotation is stored as cosine and sine, because Eigen::Rotation2Dd calls
/// the C library for them at each use: that is slow, and gives different bits on different processors.
struct FrameOfBase
{
  double inclination = 0.0;                                ///< theta [rad]
  double inclination_rate = 0.0;                           ///< d theta / dt [rad/s]
  Rotation rotation{1.0, 0.0};                             ///< by theta
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  ///< D, in the world [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();      ///< dD/dt, in the world [m/s]

  /// A world vector in the axes of the base, and back.
  Eigen::Vector2d into(const Eigen::Vector2d& vector) const
  {
    const auto turned = intoBase(rotation, vector.x(), vector.y());
    return {turned.first, turned.second};
  }
  Eigen::Vector2d outOf(const Eigen::Vector2d& vector) const
  {
    const auto turned = outOfBase(rotation, vector.x(), vector.y());
    return {turned.first, turned.second};
  }

  /// The position in the frame of the base of a world position, and back.
  Eigen::Vector2d positionInto(const Eigen::Vector2d& position) const
  {
    return into(position - displacement);
  }
  Eigen::Vector2d positionOutOf(const Eigen::Vector2d& position) const
  {
    return outOf(position) + displacement;
  }

  /// Position and velocity relative to the base, from those in the world.
  BasePoint see(const Kinematics& disk) const
  {
    const auto at =
        intoBase(rotation, disk.position[0] - displacement.x(), disk.position[1] - displacement.y());
    const auto going = intoBase(rotation, disk.velocity[0] - velocity.x(), disk.velocity[1] - velocity.y());
    return {{at.first, at.second},
            {going.first + inclination_rate * at.second, going.second - inclination_rate * at.first}};
  }

  /// The periodic image at distance `length` along the base.
  Image image(double length) const
  {
    const auto shift = alongBase(rotation, length);
    return {{shift.first, shift.second},
            {-length * inclination_rate * rotation.sine, length * inclination_rate * rotation.cosine}};
  }

  void archive(StateArchive& state)
  {
    state(inclination, inclination_rate, rotation.cosine, rotation.sine, displacement.x(), displacement.y(),
          velocity.x(), velocity.y());
  }
};

}  // namespace ratchet_sieve
