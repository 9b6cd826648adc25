#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace ratchet_sieve
{

/// The quantities that a schedule commands, as their setpoint topics are called.
constexpr std::array<const char*, 3> SCHEDULED = {"inclination", "frequency", "amplitude"};

/// What to command at one time; nothing: leave it as it is.
struct ScheduleEntry
{
  double time = 0.0;                            ///< simulated [s]
  std::array<std::optional<double>, 3> values;  ///< per SCHEDULED [rad, Hz, m]
};

/// Reads a list of {time, inclination, frequency, amplitude}.
/// @param source named in errors @throws ParameterError
std::vector<ScheduleEntry> scheduleFromYaml(const YAML::Node& list, const std::string& source);

}  // namespace ratchet_sieve
