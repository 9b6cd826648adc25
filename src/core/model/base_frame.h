#pragma once

#include <Eigen/Core>

#include "model/rotation.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// A point's position and velocity in the frame of the base: (s, n), s along the base, n normal to it.
struct BasePoint
{
  Eigen::Vector2d position;  ///< [m]
  Eigen::Vector2d velocity;  ///< relative to the base there [m/s]

  double s() const { return position.x(); }
  double n() const { return position.y(); }
};

/// Another position at which a disk appears: moved along the base by a periodic boundary. World frame.
struct Image
{
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d velocity =
      Eigen::Vector2d::Zero();  ///< of the shift; nonzero only while the base turns [m/s]
};

/// The frame of the base at an instant: the foot at s = 0, n = 0 lies at D in the world, and the base is
/// inclined about it by theta. The rotation is kept as cosine and sine, and not as Eigen::Rotation2Dd, which
/// asks the C library for them at each use: that takes long, and gives other bits on another processor.
struct FrameOfBase
{
  double inclination = 0.0;                                ///< theta [rad]
  double inclination_rate = 0.0;                           ///< d theta / dt [rad/s]
  Rotation rotation{1.0, 0.0};                             ///< by theta
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  ///< D, in the world [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();      ///< dD/dt, in the world [m/s]

  /// A vector of the world along the axes of the base, and back.
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

  /// A position in the frame of the base as the world has it.
  Eigen::Vector2d positionOutOf(const Eigen::Vector2d& position) const
  {
    return outOf(position) + displacement;
  }

  /// What is at this position of the world and moves at this velocity, as seen from the base.
  BasePoint see(const Eigen::Vector2d& position, const Eigen::Vector2d& speed) const
  {
    const auto at = intoBase(rotation, position.x() - displacement.x(), position.y() - displacement.y());
    const auto going = intoBase(rotation, speed.x() - velocity.x(), speed.y() - velocity.y());
    return {{at.first, at.second},
            {going.first + inclination_rate * at.second, going.second - inclination_rate * at.first}};
  }

  /// Where what the base carries appears once more, `length` along it.
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
