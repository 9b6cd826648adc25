#include "ratchet_sieve/recording/commands.h"

#include <sstream>
#include <stdexcept>
#include <string>

#include "ratchet_sieve/core/count_text.h"
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

/// A NaN is not within bounds.
void requireWithin(double value, const Interval& allowed)
{
  if (allowed.contains(value))
    return;
  std::ostringstream text;
  text << "a command has the value " << value << ": must be from " << allowed.min << " to " << allowed.max;
  throw std::invalid_argument(text.str());
}

SlewRates slewRatesOf(const std::vector<double>& values)
{
  SlewRates rates;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    rates.*q.slew_rate = values[indexOf(q.quantity)];
  return rates;
}
}  // namespace

CommandFrame setpointCommand(Quantity quantity, double setpoint)
{
  CommandFrame command;
  // The setpoints' kinds come first, in the order of Quantity.
  command.kind = static_cast<CommandKind>(indexOf(quantity));
  command.values = {setpoint};
  return command;
}

CommandFrame slewRateCommand(const SlewRates& rates)
{
  CommandFrame command;
  command.kind = CommandKind::SLEW_RATES;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    command.values.push_back(rates.*q.slew_rate);
  return command;
}

std::optional<Quantity> setpointQuantity(CommandKind kind)
{
  const auto index = static_cast<std::size_t>(kind);
  return index < QUANTITIES ? std::optional(COMMANDED_QUANTITIES[index].quantity) : std::nullopt;
}

void requireLegal(const CommandFrame& command)
{
  const std::vector<double>& values = command.values;
  if (const auto quantity = setpointQuantity(command.kind))
  {
    requireCount(values, 1);
    requireWithin(values[0], describe(*quantity).legal);
  }
  if (command.kind == CommandKind::SLEW_RATES)
  {
    requireCount(values, QUANTITIES);
    for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
      requireWithin(values[indexOf(q.quantity)], q.slew_rates);
  }
  if (command.kind == CommandKind::POUR && command.count > MOST_POURED)
    throw std::invalid_argument("a command pours " + countText(command.count, "disk"));
}

void apply(const CommandFrame& command, Simulation& simulation)
{
  if (const auto quantity = setpointQuantity(command.kind))
    return simulation.command(*quantity, command.values[0]);
  switch (command.kind)
  {
    case CommandKind::SLEW_RATES:
      return simulation.setSlewRates(slewRatesOf(command.values));
    case CommandKind::POUR:
      return simulation.pour(command.species, command.count);
    default:
      return;
  }
}

}  // namespace ratchet_sieve
