#include "ratchet_sieve/live/plant_reader.h"

#include <set>

#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/scalars.h"

namespace ratchet_sieve
{
namespace
{
constexpr double LONGEST_DELAY = 3600.0;  // s
constexpr double HIGHEST_RATE = 1e3;      // 1/s
constexpr double LOWEST_RATE = 1e-3;      // 1/s
constexpr double LARGEST = 1e9;           // kg, disks, m
constexpr std::size_t MOST_POINTS = 1000;

/// A key with a number.
template <typename Settings>
struct NumberKey
{
  const char* name;
  double Settings::*value;
  Range range;
};

template <typename Settings>
using NumberKeys = std::vector<NumberKey<Settings>>;

template <typename Settings>
void readNumbers(const Entry& entry, const NumberKeys<Settings>& keys, Settings& settings,
                 std::set<std::string> others = {})
{
  for (const auto& key : keys)
    others.insert(key.name);
  entry.requireKeys(others, {});
  for (const auto& key : keys)
    if (entry.has(key.name))
      readScalar(entry.at(key.name), key.range, settings.*key.value);
}

NumberKeys<SensorSettings> keysOf(SensorKind kind)
{
  using S = SensorSettings;
  const char* unit = kind == SensorKind::SCALE ? "kg" : "";
  NumberKeys<S> keys = {{"rate", &S::rate, {LOWEST_RATE, HIGHEST_RATE, "Hz"}},
                        {"delay", &S::delay, {0.0, LONGEST_DELAY, "s"}}};
  const auto add = [&keys](const NumberKeys<S>& more) { keys.insert(keys.end(), more.begin(), more.end()); };
  if (kind == SensorKind::COUNT)
    add({{"dead_time", &S::dead_time, {0.0, LONGEST_DELAY, "s"}},
         {"miss", &S::miss, {0.0, 1.0}},
         {"confusion", &S::confusion, {0.0, 1.0}}});
  else
    add({{"noise", &S::noise, {0.0, LARGEST, unit}},
         {"resolution", &S::resolution, {0.0, LARGEST, unit}},
         {"time_constant", &S::time_constant, {0.0, LONGEST_DELAY, "s"}}});
  if (kind == SensorKind::SCALE)
    add({{"drift", &S::drift, {-LARGEST, LARGEST, "kg/h"}},
         {"drop_height", &S::drop_height, {0.0, LARGEST, "m"}}});
  if (kind == SensorKind::LEVEL)
    add({{"from", &S::from, {-LARGEST, LARGEST, "m"}}, {"to", &S::to, {-LARGEST, LARGEST, "m"}}});
  return keys;
}

/// Pairs [Hz, factor] by rising frequency.
std::vector<std::pair<double, double>> readTable(const Entry& entry)
{
  std::vector<std::pair<double, double>> table;
  for (const Entry& point : entry.list())
  {
    const auto pair = point.list();
    if (pair.size() != 2 || table.size() == MOST_POINTS)
      entry.refuse("must be a list of pairs [frequency, factor], at most " + std::to_string(MOST_POINTS));
    auto& [frequency, factor] = table.emplace_back();
    readScalar(pair[0], {0.0, describe(Quantity::FREQUENCY).legal.max, "Hz"}, frequency);
    readScalar(pair[1], {0.0, LARGEST}, factor);
    if (table.size() > 1 && frequency <= (table.end() - 2)->first)
      pair[0].refuseValue("must be above the frequency before");
  }
  return table;
}
}  // namespace

SensorParameters readSensors(const YAML::Node& root, const std::string& source)
{
  const Entry entry(root, source, "sensors");
  entry.requireKeys({std::begin(SENSOR_KIND_NAMES), std::end(SENSOR_KIND_NAMES)}, {});
  SensorParameters parameters;
  for (std::size_t k = 0; k < SENSOR_KINDS; ++k)
    if (const char* name = SENSOR_KIND_NAMES[k]; entry.has(name))
    {
      SensorSettings& settings = parameters[k].emplace();
      readNumbers(entry.at(name), keysOf(static_cast<SensorKind>(k)), settings);
      if (settings.from > settings.to)
        entry.at(name).at("to").refuseValue("must be at least from");
    }
  return parameters;
}

DriveParameters readDrives(const YAML::Node& root, const std::string& source)
{
  using S = DriveSettings;
  const Entry entry(root, source, "actuators");
  std::set<std::string> names;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    names.insert(q.name);
  entry.requireKeys(names, {});
  DriveParameters parameters;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
  {
    if (!entry.has(q.name))
      continue;
    const Entry drive = entry.at(q.name);
    const double span = q.widest_limits.max;
    std::set<std::string> others;
    if (q.quantity == Quantity::AMPLITUDE)
      others.insert("over_frequency");
    DriveSettings& settings = parameters[indexOf(q.quantity)];
    readNumbers<S>(drive,
                   {{"dead_time", &S::dead_time, {0.0, LONGEST_DELAY, "s"}},
                    {"time_constant", &S::time_constant, {0.0, LONGEST_DELAY, "s"}},
                    {"resolution", &S::resolution, {0.0, span, q.unit}},
                    {"offset", &S::offset, {-span, span, q.unit}}},
                   settings, others);
    if (drive.has("over_frequency"))
      settings.over_frequency = readTable(drive.at("over_frequency"));
  }
  return parameters;
}

}  // namespace ratchet_sieve
