#include "ratchet_sieve/recording/statistics_window.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/resimulation.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Fig. 8: a layer on a drive of 23 Hz.
SceneDefinition layer()
{
  SceneDefinition scene = smallRing();
  scene.base = BaseDefinition();
  scene.species[0].count = scene.species[1].count = 131;
  scene.species[1].radius = 0.002;
  scene.species[1].mass = 0.001;
  return scene;
}

CollectingSink recorded(const SceneDefinition& scene, double rate)
{
  Simulation simulation(scene);
  CollectingSink sink;
  RunWatchers watchers;
  watchers.frames = {{&sink, {0.0, 0.0, 0.0, rate}}};
  runToEnd(simulation, watchers);
  return sink;
}

TEST(StatisticsWindow, IsOfWholePeriodsOneAfterTheOther)
{
  const CollectingSink sink = recorded(layer(), 10.0);
  ASSERT_EQ(sink.statistics.size(), 11u);
  EXPECT_FALSE(sink.statistics[0].species[0].granular_temperature);
  EXPECT_EQ(sink.statistics[0].collision_rates.total(), 0.0);
  double end = 0.0;
  for (std::size_t k = 1; k < sink.statistics.size(); ++k)
  {
    const StatisticsFrame& frame = sink.statistics[k];
    EXPECT_EQ(frame.window_start, end);
    end = frame.window_end;
    const double periods = 23.0 * (frame.window_end - frame.window_start);
    EXPECT_NEAR(periods, std::round(periods), 1e-9);
    EXPECT_LE(frame.window_end, frame.time);
    EXPECT_GT(frame.window_end, frame.time - 1.001 / 23.0);
    EXPECT_TRUE(frame.species[0].granular_temperature);
    EXPECT_GT(frame.collision_rates.disk_disk_rate, 0.0);
  }
}

TEST(StatisticsWindow, IsShownAgainUntilTheNextPeriodIsOver)
{
  const CollectingSink sink = recorded(layer(), 60.0);
  int repeated = 0;
  for (std::size_t k = 1; k < sink.statistics.size(); ++k)
  {
    const StatisticsFrame& before = sink.statistics[k - 1];
    const StatisticsFrame& frame = sink.statistics[k];
    if (frame.window_end > before.window_end)
      continue;
    ++repeated;
    EXPECT_EQ(frame.window_start, before.window_start);
    for (std::size_t i = 0; i < frame.species.size(); ++i)
      EXPECT_EQ(frame.species[i].granular_temperature, before.species[i].granular_temperature);
    EXPECT_TRUE(sameBits(frame.collision_rates, before.collision_rates));
  }
  EXPECT_EQ(repeated, 60 - 23);
}

TEST(StatisticsWindow, SumsUpToAllCollisions)
{
  const CollectingSink sink = recorded(layer(), 10.0);
  double collisions = 0.0;
  for (const StatisticsFrame& frame : sink.statistics)
    collisions += frame.collision_rates.total() * (frame.window_end - frame.window_start);
  // 23 Hz: the last period ends with the run.
  EXPECT_NEAR(collisions, static_cast<double>(sink.statistics.back().collisions.total()), 1e-6 * collisions);
}

TEST(StatisticsWindow, IsTheTimeBetweenFramesWhereNothingSwings)
{
  SceneDefinition scene = layer();
  scene.base.amplitude = 0.0;
  const CollectingSink sink = recorded(scene, 10.0);
  Simulation simulation(scene);
  for (std::size_t k = 0; k < sink.statistics.size(); ++k)
  {
    const StatisticsFrame& frame = sink.statistics[k];
    simulation.advanceTo(frame.time);
    for (std::size_t i = 0; i < frame.species.size(); ++i)
      EXPECT_EQ(frame.species[i].granular_temperature, simulation.granularTemperatures()[i]);
    EXPECT_EQ(frame.window_end, frame.time);
    EXPECT_EQ(frame.window_start, k > 0 ? sink.statistics[k - 1].time : 0.0);
  }
  EXPECT_GT(sink.statistics[5].collision_rates.total(), 0.0);
}

/// The first difference between a repeated run of the recorded scene and its statistics from `from` on.
std::string differenceFrom(double from, const CollectingSink& sink)
{
  Resimulation resimulation;
  SceneFrame scene = sink.scenes.at(0);
  scene.time = std::max(scene.time, from);
  resimulation.take(scene);
  for (const StatisticsFrame& frame : sink.statistics)
    if (frame.time >= from)
      resimulation.take(frame);
  resimulation.finish();
  return resimulation.difference().value_or("");
}

TEST(StatisticsWindow, ComesOutTheSameInARunThatWasTakenUp)
{
  Simulation before(layer());
  before.advanceTo(0.45);
  Simulation after(layer(), before.saveState());
  CollectingSink sink;
  RunWatchers watchers;
  watchers.frames = {{&sink, {0.0, 0.0, 0.0, 10.0}}};
  runToEnd(after, watchers);
  ASSERT_EQ(sink.scenes.at(0).time, 0.45);
  EXPECT_EQ(differenceFrom(0.45, sink), "");
}

}  // namespace
}  // namespace ratchet_sieve
