#include "ratchet_sieve/ros/schedule.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ratchet_sieve/ros/parameter_reader.h"

namespace ratchet_sieve
{
namespace
{
double finiteNumber(const YAML::Node& node, const std::string& source)
{
  double number = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, number) || !std::isfinite(number))
    throw ParameterError(source + ": must be a finite number");
  return number;
}

ScheduleEntry entryFromYaml(const YAML::Node& node, const std::string& source)
{
  if (!node.IsMap() || !node["time"])
    throw ParameterError(source + ": must be a map with the key time");
  ScheduleEntry entry;
  for (const auto& item : node)
  {
    const auto key = item.first.as<std::string>();
    const double value = finiteNumber(item.second, fmt::format("{}/{}", source, key));
    const auto* const found = std::find_if(COMMANDED_QUANTITIES.begin(), COMMANDED_QUANTITIES.end(),
                                           [&](const CommandedQuantity& q) { return key == q.name; });
    if (key == "time")
      entry.time = value;
    else if (found != COMMANDED_QUANTITIES.end())
      entry.values[indexOf(found->quantity)] = value;
    else
      throw ParameterError(
          fmt::format("{}/{}: not known: must be time, inclination, frequency or amplitude", source, key));
  }
  if (std::none_of(entry.values.begin(), entry.values.end(), [](const auto& value) { return value; }))
    throw ParameterError(source + ": commands nothing: must have inclination, frequency or amplitude");
  return entry;
}
}  // namespace

std::vector<ScheduleEntry> scheduleFromYaml(const YAML::Node& list, const std::string& source)
{
  if (!list.IsSequence())
    throw ParameterError(source + ": must be a list of {time, inclination, frequency, amplitude}");
  std::vector<ScheduleEntry> schedule;
  for (std::size_t k = 0; k < list.size(); ++k)
  {
    const std::string entry_source = source + "/" + std::to_string(k);
    schedule.push_back(entryFromYaml(list[k], entry_source));
    if (k > 0 && schedule[k].time < schedule[k - 1].time)
      throw ParameterError(entry_source + "/time: must not be before that of the entry above");
  }
  return schedule;
}

}  // namespace ratchet_sieve
