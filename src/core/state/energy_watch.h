#pragma once

#include <optional>

#include "ratchet_sieve/core/results.h"

namespace ratchet_sieve
{

class SystemState;

/// Detects a disk whose energy exceeds every energy scale of the machine. Such a run is heated without limit:
/// by elastic disks on a driven base (Fermi acceleration; Ulam, Proc. 4th Berkeley Symp. 3, 315 (1961)), by
/// an endless slope, or by a base that turns.
///
/// The scale is the energy of a disk that falls from the highest position of the scene and leaves the base
/// after one elastic bounce against its fastest motion: (sqrt(2 g H + v^2) + 2 V)^2 / 2 per mass. Disks that
/// lose energy in collisions stay within a few scales.
class EnergyWatch
{
public:
  /// Energies above this multiple of the scale are reported: 32 times the speed after one elastic bounce.
  static constexpr double ALARM = 1e3;

  explicit EnergyWatch(const SystemState& system);

  /// Checks every disk. @param time local to the epoch
  void check(double time);

  /// The largest energy of a disk so far, in scales.
  double largest() const { return largest_; }

  /// The first disk above the limit.
  const std::optional<LargeEnergy>& first() const { return first_; }

  void archive(StateArchive& state) { state(fastest_base_, largest_, first_); }

private:
  const SystemState& system_;
  double highest_;             ///< H [m]
  double start_speed_;         ///< v [m/s]
  double gravity_;             ///< [m/s^2]
  double fastest_base_ = 0.0;  ///< V, the largest speed of the base so far [m/s]
  double largest_ = 0.0;
  std::optional<LargeEnergy> first_;
};

}  // namespace ratchet_sieve
