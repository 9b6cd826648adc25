#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "ratchet_sieve/core/block_averages.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/disk.h"
#include "ratchet_sieve/core/disk_numbers.h"
#include "ratchet_sieve/core/observation.h"
#include "ratchet_sieve/core/prefetch.h"

namespace ratchet_sieve
{

/// Means over disks and time: displacements, and kinetic energies integrated exactly along every
/// flight. Sums go by disk, whatever the order of events was: so a sum has the same bits in whatever
/// strides a run was advanced. Times are the run's (not local to an epoch) unless said otherwise.
class Tally
{
public:
  /// @param spin whether disks can spin; see Plan
  Tally(const std::vector<SpeciesDefinition>& species, double gravity, bool spin);

  std::size_t disks() const { return passages_.size(); }
  void prefetchPassage(std::uint32_t id) const { prefetch(passages_[id]); }

  void entered(const Disk& disk, double time);
  void left(std::uint32_t id, double time) { passages_[id].left_when = time; }

  /// Sums up the passages of the disks that are not at these places, and forgets them.
  void keep(const std::vector<std::uint32_t>& places, const std::vector<Disk>& disks,
            const std::vector<std::uint8_t>& active);

  /// Makes room for so many disks.
  void reserve(std::size_t count) { passages_.reserve(count); }

  /// Takes in the part of a disk's flight from its own time to `time`, both local.
  void flew(std::uint32_t id, const Disk& disk, double time);

  /// The base gave the disk an impulse [N s].
  void pushed(std::uint32_t id, double x, double y);

  /// Disks of this species took part in so many contacts: two of one species collide, and each of them did.
  void collided(std::uint32_t species, std::uint64_t contacts = 1) { contacts_[species] += contacts; }

  /// Impulse given by the base to all disks [N s].
  double impulseX() const;
  double impulseY() const;

  /// What grows with every flight and contact of a disk, for who adds to it elsewhere.
  struct Running
  {
    double offset;
    double translation;
    double rotation;
    double impulse_x;
    double impulse_y;
  };

  Running running(std::uint32_t id) const
  {
    const Passage& p = passages_[id];
    return {p.offset, p.translation, p.rotation, p.impulse_x, p.impulse_y};
  }

  void setRunning(std::uint32_t id, const Running& running)
  {
    Passage& p = passages_[id];
    p.offset = running.offset;
    p.translation = running.translation;
    p.rotation = running.rotation;
    p.impulse_x = running.impulse_x;
    p.impulse_y = running.impulse_y;
  }

  /// The disk was moved by -dx in the world by a periodic boundary, and no displacement comes of it.
  void wrapped(std::uint32_t id, double dx) { passages_[id].offset += dx; }

  /// Forgets all that was counted before: the end of `settle`.
  /// @param local_time `time` in the epoch of the disks' own times
  void restart(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
               double local_time);

  /// Ends a piece of the series from which the errors of the means are found; see BlockAverages.
  void endPiece(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
                double local_time);

  /// World x travelled since the disk entered, unwrapped [m].
  double displacement(std::uint32_t id, double x) const
  {
    return x + passages_[id].offset - passages_[id].entered_x;
  }

  std::vector<SpeciesMeans> means(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active,
                                  double time, double local_time) const;

  void archive(StateArchive& state)
  {
    state(passages_, gone_, gone_impulse_x_, gone_impulse_y_, at_piece_end_, blocks_, contacts_);
  }

private:
  static constexpr double NEVER = std::numeric_limits<double>::infinity();

  /// One disk's stay in the machine. Where it left, the disk itself still is.
  struct Passage
  {
    double entered_x = 0.0;     ///< [m]
    double offset = 0.0;        ///< unwraps x [m]
    double counted_x = 0.0;     ///< unwrapped x where the counting began [m]
    double counted_from = 0.0;  ///< [s]; NEVER for what had left before the counting began
    double translation = 0.0;   ///< integral of v^2 / 2 [m^2/s]
    double rotation = 0.0;      ///< integral of spin^2 / 2 [1/s]
    double impulse_x = 0.0;     ///< given by the base [N s]
    double impulse_y = 0.0;     ///< given by the base [N s]
    double left_when = 0.0;     ///< [s]

    void archive(StateArchive& state)
    {
      state(entered_x, offset, counted_x, counted_from, translation, rotation, impulse_x, impulse_y,
            left_when);
    }
  };

  /// Sums over the passages of one species.
  struct Sums
  {
    double disks = 0.0;
    double displacement = 0.0;
    double time = 0.0;
    double displacement_squared = 0.0;
    double displacement_time = 0.0;
    double time_squared = 0.0;
    double translation = 0.0;
    double rotation = 0.0;

    void add(const Passage& passage, double x, double time);
    void archive(StateArchive& state)
    {
      state(disks, displacement, time, displacement_squared, displacement_time, time_squared, translation,
            rotation);
    }
    SpeciesMeans means(const SpeciesDefinition& species) const;
  };

  /// Adds the passage of a disk that has left, where it counts.
  static void addLeft(const Disk& disk, const Passage& passage, std::vector<Sums>& sums);
  void integrate(Passage& passage, const Disk& disk, double local_time) const;
  std::vector<Sums> sums(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
                         double local_time) const;

  std::vector<SpeciesDefinition> species_;
  double gravity_;
  bool spin_;
  std::vector<Passage> passages_;  ///< per disk
  std::vector<Sums> gone_;         ///< per species, of passages that were forgotten
  double gone_impulse_x_ = 0.0;
  double gone_impulse_y_ = 0.0;
  std::vector<Sums> at_piece_end_;       ///< per species, when the last piece ended
  std::vector<BlockAverages> blocks_;    ///< per species
  std::vector<std::uint64_t> contacts_;  ///< per species, of its disks, since the counting began
};

}  // namespace ratchet_sieve
