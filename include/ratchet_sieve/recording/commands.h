#pragma once

#include <cstdint>
#include <optional>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// Largest number of disks in one pour command. More is probably a mistake, and a recording with more is
/// damaged: the search for free positions takes seconds and grows with the square of the number.
constexpr std::uint32_t MOST_POURED = 10000;

/// A setpoint [rad, Hz or m] as a command.
CommandFrame setpointCommand(Quantity quantity, double setpoint);

CommandFrame slewRateCommand(const SlewRates& rates);

/// The quantity of a setpoint command; nothing for other commands.
std::optional<Quantity> setpointQuantity(CommandKind kind);

/// Checks a recorded command: setpoints are legal in a scene, slew rates legal for the node.
/// @throws std::invalid_argument
void requireLegal(const CommandFrame& command);

/// Applies a command at the simulation's time; PAUSE and UNPAUSE do nothing. @pre its values are legal
/// @throws std::invalid_argument if there is no such species; the state is then unchanged
void apply(const CommandFrame& command, Simulation& simulation);

}  // namespace ratchet_sieve
