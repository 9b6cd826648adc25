#include "ratchet_sieve/live/plant.h"

#include <iterator>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/scalars.h"

namespace ratchet_sieve
{
namespace
{
constexpr double LONGEST_DELAY = 3600.0;  // s
constexpr double LARGEST = 1e9;           // kg, disks, m

using Table = std::map<double, double>;  ///< factors by frequency [Hz]

/// A key of a part. Of a table, the range is that of the factors.
template <typename Settings>
struct Key
{
  const char* name;
  std::variant<double Settings::*, Table Settings::*> value;
  Range range;
  std::set<std::string> of;  ///< the parts that have it; empty: all
};

template <typename Settings>
using Keys = std::vector<Key<Settings>>;

const Keys<SensorSettings> SENSOR_KEYS = {
    {"rate", &SensorSettings::rate, {1e-3, 1e3, "Hz"}, {}},
    {"delay", &SensorSettings::delay, {0.0, LONGEST_DELAY, "s"}, {}},
    {"noise", &SensorSettings::noise, {0.0, LARGEST, "kg or disks"}, {"scale", "level"}},
    {"resolution", &SensorSettings::resolution, {0.0, LARGEST, "kg or disks"}, {"scale", "level"}},
    {"time_constant", &SensorSettings::time_constant, {0.0, LONGEST_DELAY, "s"}, {"scale", "level"}},
    {"drift", &SensorSettings::drift, {-LARGEST, LARGEST, "kg/h"}, {"scale"}},
    {"drop_height", &SensorSettings::drop_height, {0.0, LARGEST, "m"}, {"scale"}},
    {"dead_time", &SensorSettings::dead_time, {0.0, LONGEST_DELAY, "s"}, {"count"}},
    {"miss", &SensorSettings::miss, {0.0, 1.0}, {"count"}},
    {"confusion", &SensorSettings::confusion, {0.0, 1.0}, {"count"}},
    {"from", &SensorSettings::from, {-LARGEST, LARGEST, "m"}, {"level"}},
    {"to", &SensorSettings::to, {-LARGEST, LARGEST, "m"}, {"level"}},
};

Keys<DriveSettings> driveKeys(const CommandedQuantity& q)
{
  const double span = q.widest_limits.max;
  return {{"dead_time", &DriveSettings::dead_time, {0.0, LONGEST_DELAY, "s"}, {}},
          {"time_constant", &DriveSettings::time_constant, {0.0, LONGEST_DELAY, "s"}, {}},
          {"resolution", &DriveSettings::resolution, {0.0, span, q.unit}, {}},
          {"over_frequency", &DriveSettings::over_frequency, {0.0, LARGEST}, {"amplitude"}},
          {"offset", &DriveSettings::offset, {-span, span, q.unit}, {}}};
}

/// Pairs [Hz, factor].
void readScalar(const Entry& entry, const Range& range, Table& table)
{
  for (const Entry& point : entry.list())
  {
    const auto pair = point.list();
    if (pair.size() != 2)
      point.refuse("must be a pair [frequency, factor]");
    double frequency = 0.0, factor = 0.0;
    readScalar(pair[0], {0.0, describe(Quantity::FREQUENCY).legal.max, "Hz"}, frequency);
    readScalar(pair[1], range, factor);
    if (!table.emplace(frequency, factor).second)
      pair[0].refuseValue("must be another frequency than those before");
  }
}

template <typename Settings>
Settings readPart(const Entry& entry, const Keys<Settings>& keys)
{
  std::set<std::string> names;
  for (const auto& key : keys)
    if (key.of.empty() || key.of.count(entry.key()) > 0)
      names.insert(key.name);
  entry.requireKeys(names, {});
  Settings settings;
  for (const auto& key : keys)
    if (entry.has(key.name))
      std::visit([&](auto value) { readScalar(entry.at(key.name), key.range, settings.*value); }, key.value);
  return settings;
}
}  // namespace

SensorParameters readSensors(const YAML::Node& root, const std::string& source)
{
  const Entry entry(root, source, "sensors");
  entry.requireKeys({std::begin(SENSOR_KIND_NAMES), std::end(SENSOR_KIND_NAMES)}, {});
  SensorParameters parameters;
  for (std::size_t k = 0; k < std::size(SENSOR_KIND_NAMES); ++k)
    if (const char* name = SENSOR_KIND_NAMES[k]; entry.has(name))
    {
      const auto settings = readPart(entry.at(name), SENSOR_KEYS);
      parameters[static_cast<SensorKind>(k)] = settings;
      if (settings.from > settings.to)
        entry.at(name).at("to").refuseValue("must be at least from");
    }
  return parameters;
}

DriveParameters readDrives(const YAML::Node& root, const std::string& source)
{
  const Entry entry(root, source, "actuators");
  std::set<std::string> names;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    names.insert(q.name);
  entry.requireKeys(names, {});
  DriveParameters parameters;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    if (entry.has(q.name))
      parameters[indexOf(q.quantity)] = readPart(entry.at(q.name), driveKeys(q));
  return parameters;
}

}  // namespace ratchet_sieve
