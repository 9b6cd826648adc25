#include "ratchet_sieve/recording/commands.h"

#include <sstream>
#include <stdexcept>
#include <string>

#include "ratchet_sieve/scene/scene_limits.h"

namespace ratchet_sieve
{
namespace
{
void requireCount(const std::vector<double>& values, std::size_t count)
{
  if (values.size() != count)
    throw std::invalid_argument("a command has " + std::to_string(values.size()) + " values, not " +
                                std::to_string(count));
}

/// A value that lies within bounds: one that is not a number does not.
double within(double value, double min, double max)
{
  if (!(value >= min && value <= max))
  {
    std::ostringstream text;
    text << "a command has the value " << value << ": must be from " << min << " to " << max;
    throw std::invalid_argument(text.str());
  }
  return value;
}

double setpointOf(const std::vector<double>& values, double min, double max)
{
  requireCount(values, 1);
  return within(values[0], min, max);
}

SlewRates slewRatesOf(const std::vector<double>& values)
{
  requireCount(values, 3);
  return {within(values[0], SLOWEST_SLEW.inclination, FASTEST_SLEW.inclination),
          within(values[1], SLOWEST_SLEW.frequency, FASTEST_SLEW.frequency),
          within(values[2], SLOWEST_SLEW.amplitude, FASTEST_SLEW.amplitude)};
}
}  // namespace

void apply(const CommandFrame& command, Simulation& simulation)
{
  const std::vector<double>& values = command.values;
  switch (command.kind)
  {
    case CommandKind::INCLINATION:
      return simulation.commandInclination(setpointOf(values, -STEEPEST_INCLINATION, STEEPEST_INCLINATION));
    case CommandKind::FREQUENCY:
      return simulation.commandFrequency(setpointOf(values, 0.0, LARGEST_FREQUENCY));
    case CommandKind::AMPLITUDE:
      return simulation.commandAmplitude(setpointOf(values, 0.0, LARGEST_AMPLITUDE));
    case CommandKind::SLEW_RATES:
      return simulation.setSlewRates(slewRatesOf(values));
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
