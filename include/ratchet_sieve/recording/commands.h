#pragma once

#include <cstdint>
#include <optional>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// More disks at once are a slip, or no recording of this program: to find room for them takes seconds, which
/// grow with their square.
constexpr std::uint32_t MOST_POURED = 10000;

/// A setpoint [rad, Hz or m] as a command.
CommandFrame setpointCommand(Quantity quantity, double setpoint);

CommandFrame slewRateCommand(const SlewRates& rates);

/// The quantity of which a command is a setpoint, if it is one.
std::optional<Quantity> setpointQuantity(CommandKind kind);

/// Gives a simulation a command at its present time; PAUSE and UNPAUSE change nothing in it.
/// Setpoints may be what a scene may say, slew rates what the node takes.
/// @throws std::invalid_argument where there is no such species or value; nothing has changed then
void apply(const CommandFrame& command, Simulation& simulation);

}  // namespace ratchet_sieve
