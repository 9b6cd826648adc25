#include "commanded_quantities.h"

#include <stdexcept>

#include <fmt/format.h>

namespace ratchet_sieve
{
namespace
{

const CommandedQuantity& quantityOf(const std::string& name)
{
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
    if (name == quantity.name)
      return quantity;
  throw std::invalid_argument("there is no quantity " + name);
}

void requireWithin(const std::string& name, double value, const Interval& allowed, const std::string& unit)
{
  if (!allowed.contains(value))
    throw std::invalid_argument(
        fmt::format("{} = {}: must be {} to {} {}", name, value, allowed.min, allowed.max, unit));
}

}  // namespace

void requireLegal(const Setpoints& setpoints)
{
  for (const auto& [name, setpoint] : setpoints)
    requireWithin(name, setpoint, quantityOf(name).legal, quantityOf(name).unit);
}

void commandAll(const Setpoints& setpoints, Simulation& simulation)
{
  for (const auto& [name, setpoint] : setpoints)
    simulation.command(quantityOf(name).quantity, setpoint);
}

void requireLegal(const SlewRates& rates)
{
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
    requireWithin(std::string(quantity.name) + " (slew rate)", rates.*quantity.slew_rate, quantity.slew_rates,
                  std::string(quantity.unit) + "/s");
}

}  // namespace ratchet_sieve
