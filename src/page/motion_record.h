#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion_encoding.h"

namespace ratchet_sieve
{

/// The motion of the disks, thinned so that it fits into a page.
///
/// The rule: every k-th frame is kept, and the last. Where the disks do not collide with each other, at least
/// LEAST_RATE frames a second are kept, and of the disks every m-th instead.
class MotionRecord
{
public:
  static constexpr double LEAST_RATE = 20.0;  ///< of frames [1/s]

  /// @param scene outlives this
  /// @param most_bytes that encoded() will be asked for
  MotionRecord(const SceneDefinition& scene, std::size_t most_bytes);

  void take(const ParticleFrame& frame);

  /// What was kept. The description has also `taken` (number of frames taken), `every` (k), `disk_every` (m).
  /// @param size of the bytes at most, unless the first and the last frame alone take more
  EncodedMotion encoded(std::size_t size) const;

private:
  struct Thinning
  {
    std::size_t every = 1;
    std::uint32_t disk_every = 1;
  };

  void thin(std::vector<RoundedFrame>& frames, std::size_t factor, Thinning& thinning) const;

  const SceneDefinition& scene_;
  MotionUnits units_;
  std::size_t most_bytes_;
  std::size_t taken_ = 0;
  std::size_t kept_states_ = 0;
  Thinning thinning_;
  std::vector<RoundedFrame> kept_;
  std::optional<ParticleFrame> last_;  ///< if it is not among those kept
};

}  // namespace ratchet_sieve
