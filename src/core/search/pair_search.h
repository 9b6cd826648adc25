#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "model/base_motion.h"
#include "model/disk.h"

namespace ratchet_sieve
{

/// How long until two disks touch whose relative position and velocity are these: under one gravity the
/// relative motion is a straight line. Nothing if they pass or part; 0 where they overlap and close.
inline std::optional<double> timeToContact(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                                           double distance)
{
  const double closing = position.dot(velocity);
  if (closing >= 0.0)
    return std::nullopt;
  const double excess = position.squaredNorm() - distance * distance;
  if (excess <= 0.0)
    return 0.0;
  // The distance at which they would pass comes from the cross product: as a difference of squares it
  // would lose to rounding what is small against how far apart they are.
  const double passing = position.x() * velocity.y() - position.y() * velocity.x();
  const double discriminant = velocity.squaredNorm() * distance * distance - passing * passing;
  if (discriminant < 0.0)
    return std::nullopt;
  return excess / (std::sqrt(discriminant) - closing);
}

/// A disk's first contact with another disk.
struct PairContact
{
  double time = std::numeric_limits<double>::infinity();  ///< [s]
  std::uint32_t partner = 0;
  int shift = 0;  ///< which image of the partner: so many widths to the right of it

  /// Ties go to the smaller slot.
  bool isBefore(const PairContact& other) const
  {
    return time < other.time || (time == other.time && partner < other.partner);
  }

  /// Becomes the other where that is earlier.
  void take(const PairContact& other)
  {
    if (!other.isBefore(*this))
      return;
    time = other.time;
    partner = other.partner;
    shift = other.shift;
  }

  void archive(StateArchive& state) { state(time, partner, shift); }
};

/// What a search for pairs reads of the machine.
struct PairScene
{
  const std::vector<Disk>& disks;    ///< by slot
  const std::vector<double>& radii;  ///< per species [m]
  const BaseMotion& motion;
  double width;            ///< of the base [m]
  double gravity;          ///< [m/s^2]
  double time_resolution;  ///< times closer than this count as equal [s]

  double radius(std::uint32_t slot) const { return radii[disks[slot].species]; }

  /// Where the image `shift` widths to the right appears at `time`, relative to the disk itself.
  Image image(double shift, double time) const
  {
    return shift == 0.0 ? Image() : motion.at(time).image(shift * width);
  }
};

/// When one disk, flying on from a given time, touches others.
class PairSearch
{
public:
  /// @param scene outlives this
  PairSearch(const PairScene& scene, std::uint32_t slot, double from)
      : scene_(scene),
        slot_(slot),
        from_(from),
        radius_(scene.radius(slot)),
        course_(courseAt(scene.disks[slot], from, scene.gravity)),
        until_(scene.motion.nextChange().value_or(std::numeric_limits<double>::infinity()))
  {
  }

  /// The first contact with any of the images of these disks that lie `shift` widths to the right of them.
  /// However late it is; but on a base that moves to its setpoints, only until all is predicted anew. The
  /// disk itself may be among them, and does not count.
  PairContact firstAmong(const std::uint32_t* others, std::size_t count, int shift) const;

  /// The same for any of the images up to `most_laps` widths to either side: in closed form, for those that
  /// the disk flies past on the way. @pre the base is periodic and does not turn
  PairContact firstOnRing(const std::uint32_t* others, std::size_t count, int most_laps) const;

  /// The same for one other disk: without its lanes, and so the reference for it.
  std::optional<double> contactWith(std::uint32_t other, int shift) const
  {
    const Disk& disk = scene_.disks[other];
    const double distance = radius_ + scene_.radius(other);
    if (shift != 0)
      return contactAcrossSeam(disk, shift, distance);
    return contact(disk, Image(), distance);
  }

private:
  /// How many disks are tested side by side.
  static constexpr std::size_t LANES = 16;

  struct Lanes;

  /// The disk as seen from another.
  struct Relative
  {
    Two position;     ///< [m]
    Two velocity;     ///< [m/s]
    double distance;  ///< at which they touch [m]
  };

  /// @param position of the disk, as the other's image sees it
  Relative relativeTo(std::uint32_t slot, Two position) const
  {
    // Relative to itself a disk is at rest, to the last bit: no contact is found.
    const Course other = courseAt(scene_.disks[slot], from_, scene_.gravity);
    return {position - other.position, course_.velocity - other.velocity, radius_ + scene_.radius(slot)};
  }

  PairContact firstOfLanes(const std::uint32_t* others, std::size_t count, int shift,
                           const Image& image) const;

  std::optional<double> contact(const Disk& other, const Image& image, double distance) const
  {
    // Under one gravity the parabolas differ by a straight line, but the two states are of different times.
    const Course course = courseAt(other, from_, scene_.gravity);
    const Eigen::Vector2d position = vectorOf(course_.position) - image.shift - vectorOf(course.position);
    const auto time_to_contact =
        timeToContact(position, vectorOf(course_.velocity - course.velocity), distance);
    if (!time_to_contact || from_ + *time_to_contact >= until_)
      return std::nullopt;
    return from_ + *time_to_contact;
  }

  std::optional<double> contactAcrossSeam(const Disk& other, int shift, double distance) const;
  std::optional<double> contactAcrossTurningSeam(const Disk& other, int shift, double distance) const;

  const PairScene& scene_;
  std::uint32_t slot_;
  double from_;
  double radius_;
  Course course_;  ///< at `from`
  double until_;
};

}  // namespace ratchet_sieve
