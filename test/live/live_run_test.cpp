#include "ratchet_sieve/live/live_run.h"

#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// A recording is a sampler of its own, with a clock and pauses of its own.
TEST(LiveRun, leavesPausesOutOfTheRealTimeFactorThatIsRecorded)
{
  std::chrono::steady_clock::time_point now;
  LiveRun run(smallMixture(), FrameRates(), {}, 0.0, 2.0, [&] { return now; });
  run.setUnderWay(false);
  CollectingSink shown;
  CollectingSink recorded;
  run.record(recorded, FrameRates());
  run.takeDue(shown);
  const auto advance = [&](double time)
  {
    run.setUnderWay(true);
    while (run.time() < time)
      run.advanceTo(time, shown);
    now += std::chrono::milliseconds(100);
    run.takeAll(shown);
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
}  // namespace
}  // namespace ratchet_sieve
