#include "ratchet_sieve/recording/run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

constexpr double FOREVER = std::numeric_limits<double>::infinity();

/// Samples a run to `end`.
CollectingSink sampled(const FrameRates& rates, double start, double end)
{
  ratchet_sieve::Run run(Simulation(smallRing(), start), end);
  CollectingSink sink;
  run.add(sink, rates);
  run.takeDue();
  while (!run.finished())
    run.advanceTo(end);
  run.takeAll();
  return sink;
}

TEST(Run, TakesFramesExactlyOnTheirTimes)
{
  const CollectingSink sink = sampled({60.0, 30.0, 7.0, 10.0}, 0.0, 1.0);
  ASSERT_EQ(sink.particles.size(), 61u);
  for (std::size_t k = 0; k < sink.particles.size(); ++k)
    EXPECT_EQ(sink.particles[k].time, static_cast<double>(k) / 60.0);
  ASSERT_EQ(sink.bases.size(), 8u);
  for (std::size_t k = 0; k < sink.bases.size(); ++k)
    EXPECT_EQ(sink.bases[k].time, static_cast<double>(k) / 7.0);
  EXPECT_EQ(sink.bins.size(), 31u);
  EXPECT_EQ(sink.statistics.size(), 11u);
  EXPECT_EQ(sink.scenes.size(), 1u);
}

TEST(Run, CountsFromWhereItStarts)
{
  const CollectingSink sink = sampled({10.0, 0.0, 0.0, 0.0}, 0.3, 0.65);
  std::vector<double> times;
  for (const ParticleFrame& frame : sink.particles)
    times.push_back(frame.time);
  EXPECT_EQ(times, (std::vector<double>{0.3, 0.3 + 0.1, 0.3 + 0.2, 0.3 + 3 / 10.0, 0.65}));
}

TEST(Run, AtRateZeroTakesFirstAndLastOnce)
{
  Simulation simulation(smallRing());
  ratchet_sieve::Run run(simulation, FOREVER);
  CollectingSink sink;
  run.add(sink, {0.0, 0.0, 0.0, 0.0});
  EXPECT_EQ(run.nextTime(), 0.0);
  run.takeDue();
  run.takeAll();
  EXPECT_EQ(sink.particles.size(), 1u);
  EXPECT_TRUE(std::isinf(run.nextTime()));
  simulation.advanceTo(0.7);
  run.takeAll();
  run.takeAll();
  ASSERT_EQ(sink.particles.size(), 2u);
  EXPECT_EQ(sink.particles[1].time, 0.7);
  EXPECT_EQ(sink.statistics.size(), 2u);
}

TEST(Run, TakesOneFrameForTimesThatWerePassedOver)
{
  Simulation simulation(smallRing());
  ratchet_sieve::Run run(simulation, FOREVER);
  CollectingSink sink;
  run.add(sink, {10.0, 10.0, 10.0, 10.0});
  run.takeDue();
  simulation.advanceTo(0.55);
  run.takeDue();
  ASSERT_EQ(sink.particles.size(), 2u);
  EXPECT_EQ(sink.particles[1].time, 0.55);
  EXPECT_EQ(run.nextTime(), 6 / 10.0);
}

TEST(Run, TakesWhatIsObservedOfScenesThatAskForItOrHaveSizes)
{
  for (const auto& [observe, sizes, names] : {std::tuple(false, false, std::vector<std::string>{}),
                                              {true, false, {"height_profile", "mass_flow"}},
                                              {false, true, {"size_classes"}}})
  {
    SceneDefinition scene = smallMixture();
    if (observe)
      scene.observe = {"height_profile", "mass_flow"};
    if (sizes)
      scene.species[0].size.spread = 0.2;
    Simulation simulation(scene);
    ratchet_sieve::Run run(simulation, FOREVER);
    CollectingSink sink;
    run.add(sink, {0.0, 0.0, 0.0, 0.0, 10.0});
    for (int k = 0; k <= 5; ++k)
    {
      simulation.advanceTo(0.1 * k);
      run.takeDue();
    }
    ASSERT_EQ(sink.observed.size(), names.empty() ? 0u : 6u);
    for (const ObservedFrame& frame : sink.observed)
    {
      ASSERT_EQ(frame.observed.size(), names.size());
      for (std::size_t k = 0; k < names.size(); ++k)
        EXPECT_EQ(frame.observed[k].name, names[k]);
    }
    if (sizes)
    {
      const ObservedRow& row = sink.observed.back().observed[0].rows.at(0);
      EXPECT_EQ(row.species, scene.species[0].name);
      double disks = 0.0;
      for (const char* column : {"left", "right", "on_base"})
        for (const ObservedColumn& each : row.table)
          if (each.name == column)
            for (const std::optional<double>& count : each.values)
              disks += *count;
      EXPECT_EQ(disks, scene.species[0].count);
    }
  }
}

/// Wants all frames but those of kinds that are left out.
class ChoosySink : public CollectingSink
{
public:
  bool wants(FrameKind kind) const override { return left_out.count(kind) == 0; }

  std::set<FrameKind> left_out = {FrameKind::PARTICLES, FrameKind::STATISTICS};
};

TEST(Run, MakesNothingThatIsNotWanted)
{
  Simulation simulation(smallRing());
  ratchet_sieve::Run run(simulation, FOREVER);
  ChoosySink sink;
  run.add(sink, {10.0, 10.0, 10.0, 10.0});
  run.takeDue();
  simulation.advanceTo(0.1);
  run.takeDue();
  EXPECT_EQ(sink.bases.size(), 2u);
  EXPECT_EQ(sink.bins.size(), 2u);
  EXPECT_TRUE(sink.particles.empty());
  EXPECT_TRUE(sink.statistics.empty());

  // A later subscriber begins with the next frame; skipped frames are not made up for.
  sink.left_out.clear();
  run.takeDue();
  EXPECT_TRUE(sink.particles.empty());
  EXPECT_EQ(run.nextTime(), 2 / 10.0);
  simulation.advanceTo(0.2);
  run.takeDue();
  ASSERT_EQ(sink.particles.size(), 1u);
  EXPECT_EQ(sink.particles[0].time, 0.2);
  ASSERT_EQ(sink.statistics.size(), 1u);
  EXPECT_GT(sink.statistics[0].real_time_factor, 0.0);
  EXPECT_EQ(run.realTimeFactor(), sink.statistics[0].real_time_factor);
}

/// A wall clock set by the test.
struct HandClock
{
  std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();

  void pass(double seconds)
  {
    now += std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(seconds));
  }
};

TEST(Run, LeavesOutOfTheRealTimeFactorWhatTheRunStoodStill)
{
  HandClock clock;
  Simulation simulation(smallRing());
  ratchet_sieve::Run run(simulation, FOREVER, [&] { return clock.now; });
  CollectingSink sink;
  run.add(sink, {0.0, 0.0, 0.0, 10.0});
  run.takeDue();
  // Twice real time; paused in the middle of the second frame, stepped through the fourth.
  clock.pass(0.05);
  simulation.advanceTo(0.1);
  run.takeDue();
  clock.pass(0.02);
  run.setUnderWay(false);
  clock.pass(100.0);
  run.setUnderWay(false);
  clock.pass(100.0);
  run.setUnderWay(true);
  run.setUnderWay(true);
  clock.pass(0.03);
  simulation.advanceTo(0.2);
  run.takeDue();
  clock.pass(0.02);
  simulation.advanceTo(0.25);
  run.setUnderWay(false);
  clock.pass(100.0);
  run.takeAll();
  clock.pass(100.0);
  run.setUnderWay(true);
  clock.pass(0.01);
  simulation.advanceTo(0.3);
  run.takeDue();

  std::vector<double> factors;
  for (const StatisticsFrame& frame : sink.statistics)
    factors.push_back(frame.real_time_factor);
  ASSERT_EQ(factors.size(), 5u);
  EXPECT_EQ(factors[0], 0.0);
  EXPECT_NEAR(factors[1], 2.0, 1e-6);
  EXPECT_NEAR(factors[2], 2.0, 1e-6);
  EXPECT_NEAR(factors[3], 2.5, 1e-6);  // before the pause: 0.05 s in 0.02 s
  EXPECT_NEAR(factors[4], 5.0, 1e-6);  // after it: 0.05 s in 0.01 s
}

void advanceTo(Run& run, double time)
{
  run.takeDue();
  while (run.time() < time)
    run.advanceTo(time);
}

TEST(Run, ObservesNoPeriodsWhereNobodyWantsStatistics)
{
  ratchet_sieve::Run run(Simulation(smallRing()), 1.0);
  ChoosySink listener;
  run.add(listener, FrameRates());
  advanceTo(run, 0.75);
  const StatisticsFrame now = run.now<StatisticsFrame>();
  EXPECT_EQ(now.window_start, 0.75);
  EXPECT_EQ(now.window_end, 0.75);
  EXPECT_EQ(now.collision_rates.total(), 0.0);
  for (const auto& species : now.species)
    EXPECT_FALSE(species.granular_temperature);
}

/// A listener that disconnects at times sees windows of whole periods that began while it was connected, with
/// the rates and temperatures of these periods.
TEST(Run, ShowsPeriodsThatBeganWhileSomebodyListened)
{
  std::vector<PeriodRecord> periods;
  Simulation reference(smallRing());
  reference.observePeriods([&](const PeriodRecord& period) { periods.push_back(period); });
  reference.advanceTo(1.0);
  ratchet_sieve::Run run(Simulation(smallRing()), 1.0);
  ChoosySink listener;
  run.add(listener, {0.0, 0.0, 0.0, 50.0});
  std::size_t windows = 0;
  // The second time, the listener disconnects within a period, and reconnects before the frame is due.
  for (const auto& [from, until] : {std::pair(0.21, 0.507), std::pair(0.512, 0.9)})
  {
    listener.left_out = {FrameKind::STATISTICS};
    advanceTo(run, from);
    listener.left_out.clear();
    listener.statistics.clear();
    advanceTo(run, until);
    for (const StatisticsFrame& frame : listener.statistics)
    {
      EXPECT_GE(frame.window_start, from);
      if (frame.window_end == frame.window_start)
        continue;
      const auto period = std::find_if(periods.begin(), periods.end(),
                                       [&](const PeriodRecord& candidate)
                                       { return std::abs(candidate.start - frame.window_start) < 1e-12; });
      ASSERT_NE(period, periods.end());
      EXPECT_NEAR(frame.window_end, period->end, 1e-12);
      EXPECT_NEAR(frame.collision_rates.disk_disk_rate * period->duration, period->collisions.disk_disk,
                  1e-9);
      EXPECT_EQ(frame.species[0].granular_temperature, period->temperatures[0].mean());
      ++windows;
    }
  }
  EXPECT_GT(windows, 20u);
}

TEST(BinFrame, CountsAndRates)
{
  Simulation simulation(smallMixture());
  EXPECT_FALSE(makeBinFrame(simulation).quality);
  EXPECT_FALSE(makeBinFrame(simulation).processed);
  simulation.advanceTo(2.0);
  const BinFrame frame = makeBinFrame(simulation);
  EXPECT_EQ(frame.species, (std::vector<std::string>{"A", "B"}));
  ASSERT_GT(frame.bins[0].counted() + frame.bins[1].counted(), 0u);
  EXPECT_EQ(frame.bins[0].counted() + frame.bins[0].on_base, 6u);
  EXPECT_EQ(frame.processed, processedRatio(frame.bins));
  EXPECT_EQ(frame.quality, bestSeparation(frame.bins).quality());
}

}  // namespace
}  // namespace ratchet_sieve
