#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "model/base_motion.h"
#include "model/disk.h"
#include "model/motion.h"
#include "model/slot_array.h"

namespace ratchet_sieve
{

/// The time until two disks touch, from their relative position and velocity: both have the same gravity, so
/// their relative motion is a straight line. Nothing if they pass or separate; 0 if they overlap and
/// approach.
inline std::optional<double> timeToContact(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                                           double distance)
{
  const double closing = position.dot(velocity);
  if (closing >= 0.0)
    return std::nullopt;
  const double squared_distance = distance * distance;
  const double excess = position.squaredNorm() - squared_distance;
  if (excess <= 0.0)
    return 0.0;
  // The distance at which they would pass is computed from the cross product. A difference of squares would
  // lose it to rounding if the disks are far apart.
  const double passing = position.x() * velocity.y() - position.y() * velocity.x();
  const double discriminant = velocity.squaredNorm() * squared_distance - passing * passing;
  if (discriminant < 0.0)
    return std::nullopt;
  return excess / (std::sqrt(discriminant) - closing);
}

/// The time since two disks that overlap have touched, if they have moved as they do now. The same motion as
/// in timeToContact(), backwards. @param excess the square of their distance minus that of the sum of the
/// radii, < 0
inline double timeSinceContact(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                               double excess)
{
  const double speed_squared = velocity.squaredNorm();
  const double parting = position.dot(velocity);
  return (parting + std::sqrt(parting * parting - speed_squared * excess)) / speed_squared;
}

/// A disk's first contact with another disk.
struct PairContact
{
  double time = std::numeric_limits<double>::infinity();  ///< [s]
  std::uint32_t partner = 0;
  int shift = 0;  ///< image of the partner, in widths to its right

  /// Ties are broken by the smaller slot.
  bool isBefore(const PairContact& other) const
  {
    return time < other.time || (time == other.time && partner < other.partner);
  }

  /// Becomes the other one if that is earlier.
  void keepEarlier(const PairContact& other)
  {
    if (other.isBefore(*this))
      *this = other;
  }

  void archive(StateArchive& state) { state(time, partner, shift); }
};

/// Position and velocity of a disk relative to another one.
struct Relative
{
  Two position;     ///< [m]
  Two velocity;     ///< [m/s]
  double distance;  ///< at which they touch [m]
};

/// A disk's flight without its fall, which it has in common with all others: a straight line.
struct FlightLine
{
  Two position;   ///< at time 0 [m]
  Two velocity;   ///< [m/s]
  double radius;  ///< [m]

  /// @param shift of the other's image that is meant [m]
  explicit FlightLine(const Disk& disk, const Eigen::Vector2d& shift = Eigen::Vector2d::Zero())
      : position(twoOf(disk.position) - twoOf(shift)), velocity(twoOf(disk.velocity)), radius(disk.radius)
  {
  }

  /// Relative to the other disk. Prediction and execution of a contact use this one expression. With another
  /// one, rounding could predict a contact that is then found opening, again and again. A disk is exactly at
  /// rest relative to itself: no contact is found.
  Relative seenFrom(const Disk& other, double time) const
  {
    const Two passing = velocity - twoOf(other.velocity);
    return {(position - twoOf(other.position)) + passing * time, passing, radius + other.radius};
  }
};

/// The members of the machine that a pair search reads.
struct PairScene
{
  const SlotArray<Disk>& disks;  ///< by slot
  const BaseMotion& motion;
  double width;            ///< of the base [m]
  double time_resolution;  ///< times that differ by less are treated as equal [s]

  /// The image `shift` widths to the right, relative to the disk itself, at `time`.
  Image image(double shift, double time) const { return motion.image(shift * width, time); }
};

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

/// Finds the contacts of one disk with others, on its flight from a given time on.
class PairSearch
{
public:
  /// @param scene outlives this
  PairSearch(const PairScene& scene, std::uint32_t slot, double from)
      : scene_(scene),
        slot_(slot),
        from_(from),
        line_(scene.disks[slot]),
        until_(scene.motion.nextChange().value_or(std::numeric_limits<double>::infinity()))
  {
  }

  /// The first contact with the images of these disks that are `shift` widths to their right. There is no
  /// limit in time, except on a base that moves to its setpoints: up to the next new prediction. The disk
  /// itself may be in the list and is ignored.
  PairContact firstAmong(const std::uint32_t* others, std::size_t count, int shift) const;

  /// The same where `shift` is relative to the images in the grid on a turning base.
  /// @param images per slot, in widths: see DiskCells::images()
  PairContact firstAmong(const std::uint32_t* others, std::size_t count, int shift,
                         const std::int32_t* images) const;

  /// The first contact with any of these disks' images up to `most_laps` widths to either side, in closed
  /// form for those that the disk passes. @pre the base is periodic and does not turn
  PairContact firstOnRing(const std::uint32_t* others, std::size_t count, int most_laps) const;

  /// The contact with one other disk, without SIMD: the reference for the SIMD version.
  std::optional<double> contactWith(std::uint32_t other, int shift) const
  {
    if (shift != 0 && scene_.motion.turning())
      return contactAcrossTurningSeam(scene_.disks[other], shift);
    const Relative seen = FlightLine(scene_.disks[slot_], scene_.image(shift, from_).shift)
                              .seenFrom(scene_.disks[other], from_);
    const auto time_to_contact =
        timeToContact(vectorOf(seen.position), vectorOf(seen.velocity), seen.distance);
    if (!time_to_contact || from_ + *time_to_contact >= until_)
      return std::nullopt;
    return from_ + *time_to_contact;
  }

private:
  /// Number of disks tested together.
  static constexpr std::size_t LANES = 16;

  struct Lanes;

  [[gnu::always_inline]] PairContact firstOfLanes(const std::uint32_t* others, std::size_t count, int shift,
                                                  const Image& image) const;

  std::optional<double> contactAcrossTurningSeam(const Disk& other, int shift) const;

  const PairScene& scene_;
  std::uint32_t slot_;
  double from_;
  FlightLine line_;
  double until_;
};

}  // namespace ratchet_sieve
