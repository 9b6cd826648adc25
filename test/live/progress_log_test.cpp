#include "ratchet_sieve/live/progress_log.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// The log lines of a run from `start` to `end`, checked every eighth of a second.
std::vector<std::string> linesOf(double start, double end, ProgressLog& log)
{
  LiveRun run(smallMixture(), FrameRates(), {}, start, end);
  CollectingSink sink;
  std::vector<std::string> percents;
  const auto look = [&]
  {
    if (const auto line = log.line(run))
      percents.push_back(line->substr(0, line->find(" s,")));
  };
  look();
  for (double time = start; !run.finished(); time += 0.125)
  {
    while (run.time() < time && !run.finished())
      run.advanceTo(time, sink);
    look();
  }
  return percents;
}

using Lines = std::vector<std::string>;

TEST(ProgressLog, speaksAtEveryTenth)
{
  ProgressLog log;
  EXPECT_EQ(linesOf(0.0, 0.5, log), (Lines{" 20 %: 0.1", " 50 %: 0.2", " 70 %: 0.4", "100 %: 0.5"}));
}

/// As after a reset with keep_time, or after reset_world.
TEST(ProgressLog, countsFromTheStartOfARun)
{
  ProgressLog log;
  EXPECT_EQ(linesOf(30.0, 30.5, log), (Lines{" 20 %: 30.1", " 50 %: 30.2", " 70 %: 30.4", "100 %: 30.5"}));
}

TEST(ProgressLog, beginsAnewWithARun)
{
  ProgressLog log;
  const Lines first = linesOf(0.0, 0.5, log);
  EXPECT_EQ(linesOf(0.0, 0.5, log), first);
}

/// The last line of a run, without its time.
std::string lastLineOf(const SceneDefinition& scene)
{
  LiveRun run(scene, FrameRates(), {}, 0.0, scene.duration);
  CollectingSink sink;
  while (!run.finished())
    run.advanceTo(scene.duration, sink);
  ProgressLog log;
  const std::string line = log.line(run).value();
  return line.substr(line.find(", ") + 2);
}

TEST(ProgressLog, tellsWhatHasLeftAnOpenBase)
{
  EXPECT_NE(lastLineOf(smallMixture()).find(" disks left, "), std::string::npos);
}

TEST(ProgressLog, tellsTheDriftWhereNothingCanLeave)
{
  SceneDefinition scene = smallRing();
  scene.settle = 0.25;
  Simulation same(scene);
  same.advanceTo(scene.duration);
  EXPECT_EQ(lastLineOf(scene), fmt::format("<V_x> A {:+.2f}, B {:+.2f} mm/s", 1e3 * *same.means()[0].mean_vx,
                                           1e3 * *same.means()[1].mean_vx));
  scene.boundary = Boundary::WALLED;
  scene.settle = scene.duration;
  EXPECT_EQ(lastLineOf(scene), "<V_x> is not counted yet");
}

TEST(ProgressLog, findsARunOfNoDurationAtItsEnd)
{
  ProgressLog log;
  EXPECT_EQ(linesOf(2.0, 2.0, log), Lines{"100 %: 2.0"});
}
}  // namespace
}  // namespace ratchet_sieve
