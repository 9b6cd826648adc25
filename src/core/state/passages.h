#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/disk.h"
#include "model/prefetch.h"
#include "state/disk_ids.h"

namespace ratchet_sieve
{

/// One disk's stay in the machine: the sums over its flights. Kept after the disk has left. One cache line.
struct alignas(64) Passage
{
  /// Value of counted_from for disks that had left before the counting began.
  static constexpr double NEVER = std::numeric_limits<double>::infinity();

  double entered_x = 0.0;     ///< [m]
  double offset = 0.0;        ///< unwraps x [m]
  double counted_x = 0.0;     ///< unwrapped x at the start of the counting [m]
  double counted_from = 0.0;  ///< [s]; or NEVER
  double translation = 0.0;   ///< integral of v^2 / 2 [m^2/s]
  double rotation = 0.0;      ///< integral of spin^2 / 2 [1/s]
  double left_when = 0.0;     ///< [s]
  double angle = 0.0;         ///< at the disk's own time [rad]

  /// Whether any part of it counts.
  bool counts() const { return counted_from < NEVER; }

  void archive(StateArchive& state)
  {
    state(entered_x, offset, counted_x, counted_from, translation, rotation, left_when, angle);
  }
};

/// Displacements, and kinetic energies integrated exactly along every flight. Summed per disk, so that the
/// bits do not depend on the calls of advanceTo(). Times are the run's (not local to an epoch) unless stated
/// otherwise.
class Passages
{
public:
  /// @param spin whether disks can spin; see Plan
  Passages(double gravity, bool spin) : gravity_(gravity), spin_(spin) {}

  std::size_t size() const { return passages_.size(); }
  const Passage& operator[](std::uint32_t slot) const { return passages_[slot]; }
  void prefetchPassage(std::uint32_t slot) const { prefetch(passages_[slot]); }
  void reserve(std::size_t count) { passages_.reserve(count); }
  void keep(const std::vector<std::uint32_t>& slots) { keepSlots(passages_, slots); }

  void entered(const Disk& disk, double time);
  void left(std::uint32_t slot, double time) { passages_[slot].left_when = time; }

  /// Adds the part of a disk's flight from its own time to `time`, both local.
  void flew(std::uint32_t slot, const Disk& disk, double time) { integrate(passages_[slot], disk, time); }

  /// The disk was moved by -dx in the world by a periodic boundary; the displacement is unchanged.
  void wrapped(std::uint32_t slot, double dx) { passages_[slot].offset += dx; }

  /// A disk's passage including its present flight up to a local time.
  Passage until(std::uint32_t slot, const Disk& disk, double local_time) const
  {
    Passage passage = passages_[slot];
    integrate(passage, disk, local_time);
    return passage;
  }

  /// The sums that grow with every flight, for SIMD batches.
  struct Flown
  {
    double offset;
    double translation;
    double rotation;
    double angle;
  };

  void setFlown(std::uint32_t slot, const Flown& flown)
  {
    Passage& passage = passages_[slot];
    passage.offset = flown.offset;
    passage.translation = flown.translation;
    passage.rotation = flown.rotation;
    passage.angle = flown.angle;
  }

  /// Forgets all counts: the end of `settle`.
  /// @param local_time `time` in the epoch of the disks' own times
  void restart(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
               double local_time);

  /// Unwrapped path along world x since the disk entered [m].
  double displacement(std::uint32_t slot, double x) const
  {
    return x + passages_[slot].offset - passages_[slot].entered_x;
  }

  void archive(StateArchive& state) { state(passages_); }

private:
  void integrate(Passage& passage, const Disk& disk, double local_time) const;

  double gravity_;
  bool spin_;
  std::vector<Passage> passages_;  ///< per slot
};

}  // namespace ratchet_sieve
