#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

class MachineState;

/// Notices that a disk's energy leaves every scale of the machine: the run is heated without bound, by
/// elastic disks on a driven base (Fermi acceleration; Ulam, Proc. 4th Berkeley Symp. 3, 315 (1961)), by a
/// slope that never ends, or by a base that turns.
///
/// The scale is the energy of a disk that falls from the highest position of the scene and leaves the base
/// after one elastic bounce against its fastest motion: (sqrt(2 g H + v^2) + 2 V)^2 / 2 per mass. What loses
/// energy in collisions stays within a few of them.
class EnergyWatch
{
public:
  /// A disk with so many scales is said: with 32 times the speed that one bounce gives it.
  static constexpr double ALARM = 1e3;

  explicit EnergyWatch(const SceneDefinition& scene);

  /// Looks at every disk, at `time` (local to the epoch). Energy keeps along a flight: no disk is flown.
  void check(const MachineState& machine, double time);

  /// The largest energy of a disk that was seen, in scales.
  double largest() const { return largest_; }

  /// What was seen, in one line with its numbers; empty as long as all is within the scale.
  std::string text() const;

  void archive(StateArchive& state) { state(fastest_base_, largest_, first_); }

private:
  /// The first disk that was out of scale.
  struct First
  {
    double time;    ///< of the run [s]
    double energy;  ///< [J]
    double height;  ///< in the world [m]
    double scales;
    std::uint32_t disk;

    void archive(StateArchive& state) { state(time, energy, height, scales, disk); }
  };

  double highest_;             ///< H [m]
  double start_speed_;         ///< v [m/s]
  double gravity_;             ///< [m/s^2]
  double fastest_base_ = 0.0;  ///< V, of the base so far [m/s]
  double largest_ = 0.0;
  std::optional<First> first_;
};

}  // namespace ratchet_sieve
