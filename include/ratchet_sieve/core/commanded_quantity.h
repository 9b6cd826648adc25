#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// A quantity of the base that can be commanded during a run.
enum class Quantity : std::uint8_t
{
  INCLINATION,
  FREQUENCY,
  AMPLITUDE
};

constexpr std::size_t QUANTITIES = 3;

/// How fast the base follows its setpoints.
struct SlewRates
{
  double inclination = 0.1;  ///< [rad/s]
  double frequency = 10.0;   ///< [Hz/s]
  double amplitude = 0.002;  ///< [m/s]

  void archive(StateArchive& state) { state(inclination, frequency, amplitude); }
};

/// From `min` to `max`, both included.
struct Interval
{
  double min = 0.0;
  double max = 0.0;

  /// False for what is not a number.
  constexpr bool contains(double value) const { return value >= min && value <= max; }
};

/// All that is particular to one commanded quantity. Code that treats the quantities alike iterates over
/// COMMANDED_QUANTITIES.
struct CommandedQuantity
{
  Quantity quantity;
  const char* name;
  const char* unit;
  double BaseDefinition::*definition;  ///< at the start
  double DriveState::*applied;
  double DriveState::*commanded;
  double SlewRates::*slew_rate;
  Interval legal;  ///< in a scene and in a command; keeps products of the values far from overflow
  Interval usual;  ///< a node's default limits
  Interval
      widest_limits;  ///< for a node's parameters; values outside suggest a wrong unit (degrees, millimetres)
  /// Legal slew rates. Fastest: from 0 to the largest of the widest limits in 0.1 s. Slowest: the same in the
  /// longest duration that a scene may have. A faster base is no feeder, and requires new predictions for all
  /// disks so often that a run may not end.
  Interval slew_rates;
};

/// In the order of Quantity.
constexpr std::array<CommandedQuantity, QUANTITIES> COMMANDED_QUANTITIES = {{
    {Quantity::INCLINATION,
     "inclination",
     "rad",
     &BaseDefinition::inclination,
     &DriveState::inclination,
     &DriveState::commanded_inclination,
     &SlewRates::inclination,
     // Less than an upright base.
     {-1.5, 1.5},
     {-0.5, 0.5},
     {-1.5, 1.5},
     {1.5e-9, 15.0}},
    {Quantity::FREQUENCY,
     "frequency",
     "Hz",
     &BaseDefinition::frequency,
     &DriveState::frequency,
     &DriveState::commanded_frequency,
     &SlewRates::frequency,
     {0.0, 1e6},
     {0.0, 100.0},
     {0.0, 1e4},
     {1e-5, 1e5}},
    {Quantity::AMPLITUDE,
     "amplitude",
     "m",
     &BaseDefinition::amplitude,
     &DriveState::amplitude,
     &DriveState::commanded_amplitude,
     &SlewRates::amplitude,
     {0.0, 1e3},
     {0.0, 0.01},
     {0.0, 1.0},
     {1e-9, 10.0}},
}};

constexpr std::size_t indexOf(Quantity quantity)
{
  return static_cast<std::size_t>(quantity);
}

constexpr const CommandedQuantity& describe(Quantity quantity)
{
  return COMMANDED_QUANTITIES[indexOf(quantity)];
}

}  // namespace ratchet_sieve
