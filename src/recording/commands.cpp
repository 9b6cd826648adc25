#include "ratchet_sieve/recording/commands.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace ratchet_sieve
{
namespace
{
/// A base stands less than upright, as in a scene [rad].
constexpr double MAX_INCLINATION = 1.5;

constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// The values of a command, each within bounds.
const std::vector<double>& checked(const std::vector<double>& values, std::size_t count, double min,
                                   double max)
{
  if (values.size() != count)
    throw std::invalid_argument("a command has " + std::to_string(values.size()) + " values, not " +
                                std::to_string(count));
  for (const double value : values)
    if (!std::isfinite(value) || value < min || value > max)
      throw std::invalid_argument("a command has the value " + std::to_string(value));
  return values;
}
}  // namespace

void apply(const CommandFrame& command, Simulation& simulation)
{
  const std::vector<double>& values = command.values;
  switch (command.kind)
  {
    case CommandKind::INCLINATION:
      return simulation.commandInclination(checked(values, 1, -MAX_INCLINATION, MAX_INCLINATION)[0]);
    case CommandKind::FREQUENCY:
      return simulation.commandFrequency(checked(values, 1, 0.0, INFINITE)[0]);
    case CommandKind::AMPLITUDE:
      return simulation.commandAmplitude(checked(values, 1, 0.0, INFINITE)[0]);
    case CommandKind::SLEW_RATES:
      checked(values, 3, std::numeric_limits<double>::min(), INFINITE);
      return simulation.setSlewRates({values[0], values[1], values[2]});
    case CommandKind::POUR:
      if (command.count > MOST_POURED)
        throw std::invalid_argument("a command pours " + std::to_string(command.count) + " disks");
      return simulation.pour(command.species, command.count);
    case CommandKind::PAUSE:
    case CommandKind::UNPAUSE:
      return;
  }
}

}  // namespace ratchet_sieve
