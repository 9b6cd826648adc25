#include "ratchet_sieve/live/sensors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "ratchet_sieve/live/plant.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
using Sent = std::tuple<double, double, std::vector<double>>;  // when, of which measurement [s], values

SensorParameters parametersOf(const std::string& yaml)
{
  return readSensors(YAML::Load(yaml), "test");
}

/// The small mixture with sensors, and what they sent, by their names.
class Instrumented
{
public:
  explicit Instrumented(const std::string& yaml, SceneDefinition scene = smallMixture())
      : simulation_(scene), sensors_(makeSensors(parametersOf(yaml), scene, 0.0))
  {
    simulation_.observeExits(
        [this](const ExitRecord& exit)
        {
          for (Sensor& sensor : sensors_)
            sensor.take(exit);
        });
    readAll();
  }

  /// @param stride [s] of advances
  Instrumented& run(double until, double stride = 1.0)
  {
    while (simulation_.time() < until)
    {
      simulation_.advanceTo(std::min({until, simulation_.time() + stride, nextTime(sensors_)}));
      readAll();
    }
    return *this;
  }

  /// Of the only sensor.
  void fault(const std::string& fault) { sensors_.front().setFault(fault); }

  std::map<std::string, std::vector<Sent>> sent;

private:
  void readAll()
  {
    readDue(sensors_, simulation_,
            [this](const Sensor& from, const Reading& reading)
            { sent[from.info().name].emplace_back(simulation_.time(), reading.time, reading.values); });
  }

  Simulation simulation_;
  std::vector<Sensor> sensors_;
};

double valueOf(const Sent& sent)
{
  return std::get<2>(sent).front();
}

/// @return the counts of `disks` disks of the first of two species that leave a second apart, or `interval`
std::vector<double> countsOf(const std::string& settings, int disks, double interval = 1.0)
{
  SceneDefinition scene = smallRing();
  Sensor counter(2, parametersOf("{count: {rate: 1, " + settings + "}}")[SensorKind::COUNT], scene, 0.0);
  ExitRecord exit;
  for (int k = 0; k < disks; ++k)
  {
    exit.time = interval * k;
    counter.take(exit);
  }
  counter.read(Simulation(scene));
  return counter.sent().values;
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
    EXPECT_EQ(sent[k], Sent(std::get<1>(now[k]) + 0.6, std::get<1>(now[k]), std::get<2>(now[k])));
}

TEST(Sensors, HaveNoiseOfItsStandardDeviationAndAResolution)
{
  const auto sent =
      Instrumented("{scale: {rate: 1000, noise: 0.5, resolution: 0.25}}", smallRing()).run(4.0).sent;
  double sum = 0.0, squares = 0.0;
  const auto& readings = sent.at("left/scale");
  for (const Sent& reading : readings)
  {
    EXPECT_EQ(std::remainder(valueOf(reading), 0.25), 0.0);
    sum += valueOf(reading);
    squares += valueOf(reading) * valueOf(reading);
  }
  const auto count = static_cast<double>(readings.size());
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.5 / std::sqrt(count));
  // Sheppard's correction for the rounding: h^2 / 12.
  EXPECT_NEAR(squares / count, 0.25 + 0.0625 / 12.0, 4.0 * 0.25 * std::sqrt(2.0 / count));
  EXPECT_NE(sent.at("right/scale"), readings);
}

TEST(Sensors, LagDriftFeelImpactsAndAreTared)
{
  const SceneDefinition scene = smallRing();
  const std::string settings = "{scale: {rate: 1, time_constant: 2, drift: 3.6, drop_height: 0.4905}}";
  Sensor scale(0, parametersOf(settings)[SensorKind::SCALE], scene, 0.0);
  Simulation simulation(scene);
  const auto valueAt = [&](double time)
  {
    simulation.advanceTo(time);
    scale.read(simulation);
    return scale.sent().values[0];
  };
  ExitRecord exit;
  exit.mass = 4.0;
  scale.take(exit);  // at 0 s; sqrt(2 h / g) = 0.1 s^0.5: 0.316 s
  const double impact = 4.0 * std::sqrt(0.1) / 2.0;
  EXPECT_NEAR(valueAt(0.0), impact, 1e-12);
  EXPECT_NEAR(valueAt(1.0), 4.0 + (impact - 4.0) * std::exp(-0.5) + 0.001, 1e-12);
  scale.tare(1.0);
  EXPECT_NEAR(valueAt(2.0), (impact - 4.0) * (std::exp(-1.0) - std::exp(-0.5)) + 0.001, 1e-12);
  Sensor plain(0, {}, scene, 0.0);
  plain.take(exit);
  plain.tare(exit.time);
  plain.read(simulation);
  EXPECT_EQ(plain.sent().values[0], 0.0);
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
  const std::string settings = "{level: {rate: 10, noise: 1}}";
  Instrumented machine(settings);
  const auto& sent = machine.sent["level"];
  machine.run(0.25).fault("stuck");
  machine.run(0.55).fault("dropout");
  EXPECT_EQ(sent.size(), 6u);
  EXPECT_EQ(valueOf(sent[5]), valueOf(sent[2]));
  EXPECT_DOUBLE_EQ(std::get<1>(sent[5]), 0.5);
  machine.run(0.85).fault("nan");
  EXPECT_EQ(sent.size(), 6u);
  machine.run(0.95).fault("none");
  EXPECT_TRUE(std::isnan(valueOf(sent.back())));
  machine.run(1.05);
  EXPECT_EQ(sent.back(), Instrumented(settings).run(1.05).sent["level"].back());
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
  EXPECT_EQ(
      drives("{amplitude: {over_frequency: [[20, 1], [20, 2]]}}"),
      "parameter /sieve:1: amplitude.over_frequency.1.0 = 20: must be another frequency than those before");
  EXPECT_EQ(drives("{amplitude: {over_frequency: [[20]]}}"),
            "parameter /sieve:1: amplitude.over_frequency.0: must be a pair [frequency, factor]");
  EXPECT_EQ(drives("{amplitude: {over_frequency: [20, 1]}}"),
            "parameter /sieve:1: amplitude.over_frequency.0 = 20: must be a list");
}

}  // namespace
}  // namespace ratchet_sieve
