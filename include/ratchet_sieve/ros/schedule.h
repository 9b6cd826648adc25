#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/core/commanded_quantity.h"

namespace ratchet_sieve
{

/// The setpoints to command at one time; nothing: unchanged.
struct ScheduleEntry
{
  double time = 0.0;                                     ///< simulated [s]
  std::array<std::optional<double>, QUANTITIES> values;  ///< in the order of Quantity [rad, Hz, m]
};

/// Reads a list of {time, inclination, frequency, amplitude}.
/// @param source name in error messages @throws ParameterError
std::vector<ScheduleEntry> scheduleFromYaml(const YAML::Node& list, const std::string& source);

}  // namespace ratchet_sieve
