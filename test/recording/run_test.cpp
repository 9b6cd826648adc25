#include "ratchet_sieve/recording/run.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// A recording has its own sampler, with its own clock and pauses.
TEST(Run, leavesPausesOutOfTheRealTimeFactorThatIsRecorded)
{
  std::chrono::steady_clock::time_point now;
  ratchet_sieve::Run run(Simulation(smallMixture()), 2.0, [&] { return now; });
  CollectingSink shown;
  CollectingSink recorded;
  run.add(shown, FrameRates());
  run.setUnderWay(false);
  run.add(recorded, FrameRates());
  run.takeDue();
  const auto advance = [&](double time)
  {
    run.setUnderWay(true);
    while (run.time() < time)
      run.advanceTo(time);
    now += std::chrono::milliseconds(100);
    run.takeAll();
    run.setUnderWay(false);
  };
  for (const double time : {0.05, 0.15, 0.25})
  {
    now += std::chrono::seconds(100);
    advance(time);
  }
  ASSERT_EQ(recorded.statistics.size(), shown.statistics.size());
  ASSERT_GT(recorded.statistics.size(), 4u);
  for (std::size_t k = 0; k < recorded.statistics.size(); ++k)
    EXPECT_EQ(recorded.statistics[k].real_time_factor, shown.statistics[k].real_time_factor);
  EXPECT_NEAR(recorded.statistics.back().real_time_factor, 0.5, 1e-9);
}

/// Wants all frames, but statistics only while `listening`.
class Listener : public CollectingSink
{
public:
  bool wants(FrameKind kind) const override { return kind != FrameKind::STATISTICS || listening; }

  bool listening = false;
};

void advanceTo(Run& run, double time)
{
  run.takeDue();
  while (run.time() < time)
    run.advanceTo(time);
}

TEST(Run, ObservesNoPeriodsWhereNobodyWantsStatistics)
{
  ratchet_sieve::Run run(Simulation(smallRing()), 1.0);
  Listener listener;
  run.add(listener, FrameRates());
  advanceTo(run, 0.75);
  const StatisticsFrame now = run.statistics();
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
  Listener listener;
  run.add(listener, {0.0, 0.0, 0.0, 50.0});
  std::size_t windows = 0;
  // The second time, the listener disconnects within a period, and reconnects before the frame is due.
  for (const auto& [from, until] : {std::pair(0.21, 0.507), std::pair(0.512, 0.9)})
  {
    listener.listening = false;
    advanceTo(run, from);
    listener.listening = true;
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
      EXPECT_EQ(frame.species[0].granular_temperature.has_value(),
                period->temperatures[0].mean().has_value());
      ++windows;
    }
  }
  EXPECT_GT(windows, 20u);
}
}  // namespace
}  // namespace ratchet_sieve
