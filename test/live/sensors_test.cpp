#include "ratchet_sieve/live/sensors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "ratchet_sieve/live/plant_reader.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
struct Sent
{
  double sent;  // s
  double time;  // s, of the measurement
  std::vector<double> values;

  bool operator==(const Sent& other) const
  {
    return sent == other.sent && time == other.time && values == other.values;
  }
};

SensorParameters parametersOf(const std::string& yaml)
{
  return readSensors(YAML::Load(yaml), "test");
}

/// The small mixture with sensors, and what they sent, by their names.
class Instrumented
{
public:
  explicit Instrumented(const std::string& yaml, SceneDefinition scene = smallMixture())
      : simulation_(scene), sensors_(makeSensors(parametersOf(yaml), simulation_))
  {
    simulation_.observeExits(
        [this](const ExitRecord& exit)
        {
          for (Sensor& sensor : sensors_)
            sensor.take(exit);
        });
    read();
  }

  /// @param stride [s] of advances
  Instrumented& run(double until, double stride = 1.0)
  {
    while (simulation_.time() < until)
    {
      simulation_.advanceTo(std::min({until, simulation_.time() + stride, nextTime(sensors_)}));
      read();
    }
    return *this;
  }

  Sensor& sensor(const std::string& name)
  {
    return *std::find_if(sensors_.begin(), sensors_.end(),
                         [&](const Sensor& sensor) { return sensor.info().name == name; });
  }

  const Simulation& simulation() const { return simulation_; }
  std::map<std::string, std::vector<Sent>> sent;

private:
  void read()
  {
    for (Sensor& sensor : sensors_)
      sensor.read(simulation_,
                  [this](const Sensor& from, const Reading& reading) {
                    sent[from.info().name].push_back({simulation_.time(), reading.time, reading.values});
                  });
  }

  Simulation simulation_;
  std::vector<Sensor> sensors_;
};

/// @return the counts of `disks` disks of the first of two species that leave a second apart, or `interval`
std::vector<double> countsOf(const std::string& settings, int disks, double interval = 1.0)
{
  SceneDefinition scene = smallRing();
  Sensor counter(2, *parametersOf("{count: {rate: 1, " + settings + "}}")[1], scene, 0.0);
  ExitRecord exit;
  for (int k = 0; k < disks; ++k)
  {
    exit.time = interval * k;
    counter.take(exit);
  }
  std::vector<double> counts;
  counter.read(Simulation(scene), [&](const Sensor&, const Reading& reading) { counts = reading.values; });
  return counts;
}

constexpr const char* ALL = "{scale: {rate: 5}, count: {rate: 5}, level: {rate: 5}}";

TEST(Sensors, AreExactByDefault)
{
  Instrumented machine(ALL);
  machine.run(2.0);
  const std::vector<SpeciesBins> bins = machine.simulation().bins();
  ASSERT_GT(bins[0].left + bins[0].right + bins[1].left + bins[1].right, 3u);
  EXPECT_NEAR(machine.sent["left/scale"].back().values[0], bins[0].left_mass + bins[1].left_mass, 1e-12);
  EXPECT_NEAR(machine.sent["right/scale"].back().values[0], bins[0].right_mass + bins[1].right_mass, 1e-12);
  for (std::size_t k = 0; k < bins.size(); ++k)
  {
    EXPECT_EQ(machine.sent["left/count"].back().values[k], static_cast<double>(bins[k].left));
    EXPECT_EQ(machine.sent["right/count"].back().values[k], static_cast<double>(bins[k].right));
  }
  EXPECT_EQ(machine.sent["level"].front().values[0], 12.0);
  EXPECT_EQ(machine.sent["level"].back().values[0], static_cast<double>(bins[0].on_base + bins[1].on_base));
  EXPECT_EQ(machine.sent["level"].size(), 11u);
}

TEST(Sensors, ReadTheSameHoweverTheRunIsDivided)
{
  const std::string noisy =
      "{scale: {noise: 0.001, time_constant: 0.1, drop_height: 0.1, delay: 0.25}, "
      "count: {miss: 0.3, confusion: 0.3, delay: 0.07}, level: {noise: 1, from: 0, to: 0.04}}";
  const auto once = Instrumented(noisy).run(2.0).sent;
  EXPECT_EQ(Instrumented(noisy).run(2.0, 0.0137).sent, once);
  SceneDefinition other = smallMixture();
  other.seed = 2;
  EXPECT_NE(Instrumented(noisy, other).run(2.0).sent, once);
}

TEST(Sensors, SendLateWhatTheyMeasured)
{
  const auto sent = Instrumented("{level: {rate: 4, delay: 0.6}}").run(2.0).sent.at("level");
  const auto now = Instrumented("{level: {rate: 4}}").run(2.0).sent.at("level");
  ASSERT_EQ(sent.size(), 6u);
  for (std::size_t k = 0; k < sent.size(); ++k)
    EXPECT_EQ(sent[k], (Sent{0.25 * static_cast<double>(k) + 0.6, now[k].time, now[k].values}));
}

TEST(Sensors, HaveNoiseOfItsStandardDeviationAndAResolution)
{
  const auto sent =
      Instrumented("{scale: {rate: 1000, noise: 0.5, resolution: 0.25}}", smallRing()).run(4.0).sent;
  double sum = 0.0, squares = 0.0;
  const auto& readings = sent.at("left/scale");
  for (const Sent& reading : readings)
  {
    EXPECT_EQ(std::remainder(reading.values[0], 0.25), 0.0);
    sum += reading.values[0];
    squares += reading.values[0] * reading.values[0];
  }
  const auto count = static_cast<double>(readings.size());
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.5 / std::sqrt(count));
  // Sheppard's correction for the rounding: h^2 / 12.
  EXPECT_NEAR(squares / count, 0.25 + 0.0625 / 12.0, 4.0 * 0.25 * std::sqrt(2.0 / count));
  EXPECT_NE(sent.at("right/scale").back().values, readings.back().values);
}

TEST(Sensors, LagDriftFeelImpactsAndAreTared)
{
  SceneDefinition scene = smallRing();
  Sensor scale(0, *parametersOf("{scale: {rate: 1, time_constant: 2, drift: 3.6, drop_height: 0.4905}}")[0],
               scene, 0.0);
  std::vector<double> values;
  const auto read = [&](double time)
  {
    Simulation simulation(scene);
    simulation.advanceTo(time);
    scale.read(simulation,
               [&](const Sensor&, const Reading& reading) { values.push_back(reading.values[0]); });
  };
  ExitRecord exit;
  exit.mass = 4.0;
  scale.take(exit);  // at 0 s; sqrt(2 h / g) = 0.1 s^0.5: 0.316 s
  const double impact = 4.0 * std::sqrt(0.1) / 2.0;
  read(1.0);
  EXPECT_NEAR(values[0], impact, 1e-12);
  EXPECT_NEAR(values[1], 4.0 + (impact - 4.0) * std::exp(-0.5) + 0.001, 1e-12);
  scale.tare();
  read(2.0);
  EXPECT_NEAR(values[2], (impact - 4.0) * (std::exp(-1.0) - std::exp(-0.5)) + 0.001, 1e-12);
}

TEST(Sensors, MissAndConfuseDisks)
{
  constexpr int DISKS = 10000;
  const std::vector<double> counts = countsOf("miss: 0.05, confusion: 0.2", DISKS);
  EXPECT_NEAR(counts[0] + counts[1], 0.95 * DISKS, 4.0 * std::sqrt(DISKS * 0.05 * 0.95));
  EXPECT_NEAR(counts[1] / (counts[0] + counts[1]), 0.2, 4.0 * std::sqrt(0.16 / DISKS));
}

TEST(Sensors, AreBlindInTheirDeadTime)
{
  EXPECT_EQ(countsOf("dead_time: 0.25", 12, 0.125), (std::vector<double>{6.0, 0.0}));
  EXPECT_EQ(countsOf("dead_time: 0.3", 12, 0.125), (std::vector<double>{4.0, 0.0}));
}

TEST(Sensors, Fail)
{
  Instrumented machine("{level: {rate: 10, noise: 1}}");
  auto& sent = machine.sent["level"];
  machine.run(0.25);
  machine.sensor("level").setFault("stuck");
  machine.run(0.55);
  EXPECT_EQ(sent.size(), 6u);
  EXPECT_EQ(sent[5].values, sent[2].values);
  EXPECT_DOUBLE_EQ(sent[5].time, 0.5);
  machine.sensor("level").setFault("dropout");
  machine.run(0.85);
  EXPECT_EQ(sent.size(), 6u);
  machine.sensor("level").setFault("nan");
  machine.run(0.95);
  EXPECT_TRUE(std::isnan(sent.back().values[0]));
  machine.sensor("level").setFault("none");
  machine.run(1.05);
  EXPECT_EQ(sent.back().values,
            Instrumented("{level: {rate: 10, noise: 1}}").run(1.05).sent["level"].back().values);
}

template <typename Read>
std::string refusalOf(Read read, const std::string& yaml)
{
  try
  {
    read(YAML::Load(yaml), "parameter /sieve");
    return "";
  }
  catch (const SceneError& error)
  {
    return copyWithoutLines(YAML::Node(error.what())).Scalar();
  }
}

TEST(PlantReader, SaysWhatIsAllowed)
{
  const auto sensors = [](const std::string& yaml) { return refusalOf(readSensors, yaml); };
  const auto drives = [](const std::string& yaml) { return refusalOf(readDrives, yaml); };
  EXPECT_EQ(sensors("{camera: {}}"),
            "parameter /sieve:1: camera: unknown key; must be one of count, level, scale");
  EXPECT_EQ(sensors("{scale: {mis: 0.1}}").substr(0, 45), "parameter /sieve:1: scale.mis: unknown key; m");
  EXPECT_EQ(sensors("{count: {miss: 2}}"),
            "parameter /sieve:1: count.miss = 2: must be a number from 0 to 1; did you mean 0.02 (2 %)?");
  EXPECT_EQ(sensors("{count: {rate: fast}}"),
            "parameter /sieve:1: count.rate = fast: must be a number from 0.001 to 1000 Hz");
  EXPECT_EQ(sensors("{level: {from: 1, to: 0}}"), "parameter /sieve:1: level.to = 0: must be at least from");
  EXPECT_EQ(sensors("7"), "parameter /sieve: sensors = 7: must be a map");
  EXPECT_EQ(drives("{frequency: {dead_time: -1}}"),
            "parameter /sieve:1: frequency.dead_time = -1: must be a number from 0 to 3600 s");
  EXPECT_EQ(drives("{amplitude: {over_frequency: [[20, 1], [20, 2]]}}"),
            "parameter /sieve:1: amplitude.over_frequency.1.0 = 20: must be above the frequency before");
  EXPECT_EQ(drives("{amplitude: {over_frequency: [20, 1]}}"),
            "parameter /sieve:1: amplitude.over_frequency.0 = 20: must be a list");
}

}  // namespace
}  // namespace ratchet_sieve
