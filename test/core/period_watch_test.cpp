#include "observe/period_watch.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

std::vector<PeriodRecord> periodsOf(Simulation& simulation, double end)
{
  std::vector<PeriodRecord> periods;
  simulation.observePeriods([&](const PeriodRecord& period) { periods.push_back(period); });
  simulation.advanceTo(end);
  simulation.observePeriods({});
  return periods;
}

/// Checks that the drive has the phase of the run's start at the ends of a period, and nowhere within it.
void expectWhole(const SceneDefinition& scene, const PeriodRecord& period, Simulation& same)
{
  same.advanceTo(period.end);
  const double phase = same.base().phase - scene.base.phase;
  EXPECT_NEAR(std::sin(0.5 * phase), 0.0, 1e-9) << "at " << period.end << " s";
}

TEST(PeriodWatch, TellsOfEveryPeriodOnce)
{
  SceneDefinition scene = test::mixture(10);
  scene.base.phase = 1.0;
  scene.base.frequency = 7.3;
  Simulation simulation(scene);
  const std::vector<PeriodRecord> periods = periodsOf(simulation, 40.01 / 7.3);
  ASSERT_EQ(periods.size(), 40u);
  CollisionCounts counts;
  Simulation same(scene);
  for (std::size_t k = 0; k < periods.size(); ++k)
  {
    const double tolerance = 1e-14 * (1.0 + periods[k].end);
    EXPECT_NEAR(periods[k].start, static_cast<double>(k) / 7.3, tolerance);
    EXPECT_NEAR(periods[k].end, static_cast<double>(k + 1) / 7.3, tolerance);
    EXPECT_EQ(periods[k].duration, periods[k].end - periods[k].start);
    counts.add(periods[k].collisions);
    expectWhole(scene, periods[k], same);
    EXPECT_EQ(same.collisions().total(), counts.total());
    EXPECT_EQ(same.collisions().left_slope, counts.left_slope);
  }
}

TEST(PeriodWatch, AveragesAtInstantsEvenlySpreadOverThePhase)
{
  const SceneDefinition scene = test::mixture(20);
  Simulation simulation(scene), same(scene);
  for (const PeriodRecord& period : periodsOf(simulation, 0.5))
  {
    double sum = 0.0;
    for (int part = 1; part <= PeriodWatch::PARTS; ++part)
    {
      same.advanceTo(period.start + part * period.duration / PeriodWatch::PARTS);
      sum += same.granularTemperatures()[1].value();
    }
    EXPECT_EQ(period.temperatures[1].instants, static_cast<std::uint64_t>(PeriodWatch::PARTS));
    EXPECT_NEAR(period.temperatures[1].sum, sum, 1e-6 * sum);
  }
}

/// Compared with a thousand samples in each of 23 periods.
TEST(PeriodWatch, ComesNearTheMeanOverAllOfThePeriod)
{
  constexpr int INSTANTS = 1000;
  const SceneDefinition scene = test::mixture(131);
  Simulation simulation(scene), same(scene);
  std::vector<TemperatureSum> few(2), many(2);
  for (const PeriodRecord& period : periodsOf(simulation, 2.01))
  {
    if (period.start < 0.999)
      continue;
    for (std::size_t i = 0; i < 2; ++i)
      few[i].add(period.temperatures[i]);
    for (int k = 0; k < INSTANTS; ++k)
    {
      same.advanceTo(period.start + (k + 0.5) * period.duration / INSTANTS);
      const std::vector<std::optional<double>> now = same.granularTemperatures();
      for (std::size_t i = 0; i < 2; ++i)
        many[i].add(now[i].value());
    }
  }
  ASSERT_EQ(many[0].instants, 23u * INSTANTS);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(few[i].mean().value() / many[i].mean().value(), 1.0, 0.01) << i;
}

TEST(PeriodWatch, FollowsAFrequencyOnItsWay)
{
  SceneDefinition scene = test::mixture(5);
  scene.base.phase = 2.5;
  const auto told = [&]
  {
    Simulation simulation(scene);
    simulation.command(Quantity::FREQUENCY, 5.0);
    return simulation;
  };
  Simulation simulation = told(), same = told();
  const std::vector<PeriodRecord> periods = periodsOf(simulation, 4.0);
  // 23 Hz fall to 5 within 1.8 s: 25.2 turns; then 11 in 2.2 s.
  ASSERT_EQ(periods.size(), 36u);
  for (std::size_t k = 0; k < periods.size(); ++k)
  {
    expectWhole(scene, periods[k], same);
    EXPECT_EQ(periods[k].start, k > 0 ? periods[k - 1].end : 0.0);
  }
}

TEST(PeriodWatch, DropsAPeriodThatWasInterrupted)
{
  SceneDefinition scene = test::mixture(5);
  Simulation simulation(scene);
  std::vector<PeriodRecord> periods;
  simulation.observePeriods([&](const PeriodRecord& period) { periods.push_back(period); });
  simulation.setSlewRates({0.1, 1000.0, 1.0});
  simulation.advanceTo(0.5);
  simulation.command(Quantity::AMPLITUDE, 0.0);
  simulation.advanceTo(1.0);
  ASSERT_EQ(periods.size(), 11u);
  EXPECT_FALSE(simulation.swings());
  simulation.command(Quantity::AMPLITUDE, 0.001);
  simulation.advanceTo(1.2);
  // The phase continued meanwhile: the first whole period begins with the 24th turn.
  ASSERT_GT(periods.size(), 11u);
  EXPECT_NEAR(periods[11].start, 23.0 / 23.0, 1e-12);
}

TEST(PeriodWatch, LooksAtSomePeriodsOfAFastDrive)
{
  SceneDefinition scene = test::mixture(2);
  scene.base.frequency = 1e5;
  scene.base.amplitude = 1e-9;
  Simulation simulation(scene);
  const std::vector<PeriodRecord> periods = periodsOf(simulation, 0.1);
  ASSERT_EQ(periods.size(), 5u);
  for (const PeriodRecord& period : periods)
    EXPECT_NEAR(period.duration, 1e-5, 1e-12);
  EXPECT_NEAR(periods[4].start, 4.0 * PeriodWatch::LEAST_SPACING, 1.1e-5);
}

SceneDefinition flying(double drift)
{
  SceneDefinition scene = test::mixture(0);
  scene.species[0].mass = 2.0;
  scene.species[1].mass = 1.0;
  scene.initial = {{0, 0.1, 1.0, drift + 1.0, 0.0, 0.0},
                   {0, 0.2, 1.0, drift + 3.0, 4.0, 0.0},
                   {1, 0.3, 1.0, 9.0, 9.0, 0.0}};
  return scene;
}

TEST(GranularTemperature, IsHalfTheMassTimesTheVarianceWhateverTheCommonDrift)
{
  // Species 0: vx = 1, 3 (variance 1), vy = 0, 4 (variance 4): 0.5 * 2 kg * 5.
  for (const double drift : {0.0, 1e6})
  {
    const auto temperatures = Simulation(flying(drift)).granularTemperatures();
    EXPECT_NEAR(temperatures[0].value(), 5.0, 1e-9);
    EXPECT_FALSE(temperatures[1]) << "of one disk";
  }
}

}  // namespace
}  // namespace ratchet_sieve
