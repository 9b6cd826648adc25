#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// A motion as a page holds it.
///
/// The description: `frames` (their number), the units `position_unit` [m], `velocity_unit` [m/s],
/// `positions_per_velocity` [s], `spin_unit` [rad/s], `angle_steps` of a turn, `radius_unit` [m], the numbers
/// of `tracks` and `states`, and how it was thinned (see MotionRecord): `taken` (frames in all), `every` (k),
/// `disk_every` (m), `cut` (whether it ends before the run). A track is a disk in consecutive frames.
///
/// The bytes, deflated: the times of the frames [s]; columns of the tracks: id, species, radius, first frame,
/// number of frames; then columns of the states, track by track: vx, vy, x, y, spin, angle. x and y are
/// differences from the last frame's position moved on by the mean of both velocities; angle is the
/// difference from the last, from -angle_steps / 2 on; in a track's first state they are the numbers
/// themselves.
///
/// Times are doubles. A column's numbers are integers of 32 bits, the lowest bytes of all, then the next;
/// small ones of either sign are small (zigzag: 0, -1, 1, -2, ...).
struct EncodedMotion
{
  nlohmann::ordered_json description;
  std::string bytes;
};

/// The motion of the disks in rounded numbers, thinned so that it fits into a page.
///
/// The rule: every k-th frame is kept, and the last, but at least LEAST_RATE frames a second, so that a path
/// between two of them stays near the disk's. What is still too much is left out: of disks that do not
/// collide with each other all but every m-th, of others the later part of the run.
class MotionRecord
{
public:
  static constexpr double LEAST_RATE = 30.0;  ///< of frames [1/s]

  /// @param scene outlives this
  /// @param most_bytes that encoded() will be asked for; a state or a frame kept takes some ten times
  /// LEAST_STATE
  MotionRecord(const SceneDefinition& scene, std::size_t most_bytes);

  void add(const ParticleFrame& frame);

  /// What was kept. @param size of the bytes at most, unless two frames alone take more
  EncodedMotion encoded(std::size_t size) const;

private:
  struct Disk  ///< in multiples of the units
  {
    std::uint32_t id, species;
    std::int32_t x, y, vx, vy, angle, spin, radius;
  };
  struct Frame
  {
    double time = 0.0;  ///< [s]
    std::vector<Disk> disks;
  };
  struct Track;
  using State = std::array<std::int32_t, 6>;  ///< a row of the states' columns
  struct Thinning
  {
    std::size_t every = 1;
    std::uint32_t disk_every = 1;
    bool cut = false;
  };

  Frame rounded(const ParticleFrame& frame) const;
  static std::size_t mostEvery(const std::vector<Frame>& frames);
  static std::size_t countStates(const std::vector<Frame>& frames);
  bool leavesOutDisks(const std::vector<Frame>& frames, double factor) const;
  void thin(std::vector<Frame>& frames, double factor, Thinning& thinning) const;
  EncodedMotion encode(const std::vector<Frame>& frames) const;
  static std::vector<Track> tracksOf(const std::vector<Frame>& frames);
  static std::vector<State> statesOf(const std::vector<Track>& tracks, const std::vector<Frame>& frames);

  const SceneDefinition& scene_;
  double position_unit_;  ///< [m]
  double velocity_unit_;  ///< [m/s]
  double radius_unit_;    ///< [m]
  std::size_t most_bytes_;
  std::size_t taken_ = 0;
  std::size_t kept_states_ = 0;  ///< and frames
  Thinning thinning_;
  std::vector<Frame> kept_;
  std::optional<ParticleFrame> last_;  ///< if it is not among those kept
};

}  // namespace ratchet_sieve
