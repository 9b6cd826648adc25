#include "ratchet_sieve/live/journal.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
using Lines = std::vector<std::string>;

/// A journal that keeps its lines.
class Journals : public testing::Test
{
protected:
  Lines said, warned;
  Journal journal{{[this](const std::string& line) { said.push_back(line); },
                   [this](const std::string& line) { warned.push_back(line); }}};

  /// What was said since the last call.
  Lines newlySaid() { return std::exchange(said, {}); }
  Lines newlyWarned() { return std::exchange(warned, {}); }

  /// Looks at a run from `start` on, every `period`, until its end.
  void follow(const SceneDefinition& scene, double start, double end, double period)
  {
    ratchet_sieve::Run run(Simulation(scene, start), end);
    journal.look(run);
    for (double time = start; !run.finished(); time += period)
    {
      while (run.time() < time && !run.finished())
        run.advanceTo(time);
      journal.look(run);
    }
  }
};

class ProgressOfARun : public Journals
{
protected:
  Lines percents(double start, double end)
  {
    follow(smallMixture(), start, end, 0.125);
    Lines lines = newlySaid();
    for (std::string& line : lines)
      line = line.substr(0, line.find(" s,"));
    return lines;
  }

  /// The only line of a run, without its time.
  std::string lastLineOf(const SceneDefinition& scene)
  {
    ratchet_sieve::Run run(Simulation(scene), scene.duration);
    while (!run.finished())
      run.advanceTo(scene.duration);
    journal.look(run);
    const std::string line = newlySaid().at(0);
    return line.substr(line.find(", ") + 2);
  }
};

TEST_F(ProgressOfARun, IsSaidAtEveryTenth)
{
  const Lines lines = {" 20 %: 0.1", " 50 %: 0.2", " 70 %: 0.4", "100 %: 0.5"};
  EXPECT_EQ(percents(0.0, 0.5), lines);
  EXPECT_EQ(percents(0.0, 0.5), lines) << "of a run that begins anew";
  EXPECT_EQ(percents(30.0, 30.5), (Lines{" 20 %: 30.1", " 50 %: 30.2", " 70 %: 30.4", "100 %: 30.5"}))
      << "as after a reset with keep_time, or after reset_world";
  EXPECT_EQ(percents(40.0, 40.0), Lines{"100 %: 40.0"});
}

TEST_F(ProgressOfARun, TellsWhatHasLeftAnOpenBase)
{
  EXPECT_NE(lastLineOf(smallMixture()).find(" disks left, "), std::string::npos);
}

TEST_F(ProgressOfARun, TellsTheDriftWhereNothingCanLeave)
{
  SceneDefinition scene = smallRing();
  scene.settle = 0.25;
  Simulation same(scene);
  same.advanceTo(scene.duration);
  EXPECT_EQ(lastLineOf(scene), fmt::format("<V_x> A {:+.2f}, B {:+.2f} mm/s", 1e3 * *same.means()[0].mean_vx,
                                           1e3 * *same.means()[1].mean_vx));
}

TEST_F(ProgressOfARun, TellsThatTheDriftIsNotCountedYet)
{
  SceneDefinition scene = smallRing();
  scene.settle = scene.duration;
  EXPECT_EQ(lastLineOf(scene), "<V_x> is not counted yet");
}

class RequestedAccuracy : public Journals
{
protected:
  /// The number of lines that say that it is reached.
  std::size_t linesOf(double mean_vx, double start)
  {
    SceneDefinition scene = smallRing();
    scene.contact.pair_collisions = false;
    scene.species[0].count = scene.species[1].count = 64;
    scene.accuracy.mean_vx = mean_vx;
    follow(scene, start, start + 40.0, 0.1);
    std::size_t count = 0;
    for (const std::string& line : newlySaid())
      count += line.find("the requested accuracy is reached; the run continues") != std::string::npos;
    return count;
  }
};

TEST_F(RequestedAccuracy, IsSaidOnceWhenReached)
{
  EXPECT_EQ(linesOf(0.1, 0.0), 1u);
  EXPECT_EQ(linesOf(0.1, 0.0), 1u) << "of a run that begins anew at time 0";
  EXPECT_EQ(linesOf(0.1, 40.0), 1u) << "and of one whose time goes on";
}

TEST_F(RequestedAccuracy, IsNotSaidOfARunThatIsNotOrDoesNotAsk)
{
  EXPECT_EQ(linesOf(1e-7, 0.0), 0u);
  EXPECT_EQ(linesOf(0.0, 0.0), 0u);
}

/// Without gravity, `count` disks above the left wall fly over it, one every millisecond.
Run flownOver(int count, Boundary boundary = Boundary::WALLED)
{
  SceneDefinition scene = smallMixture();
  scene.boundary = boundary;
  scene.gravity = 0.0;
  scene.base.wall_height = 0.05;
  for (int k = 1; k <= count; ++k)
    scene.initial.push_back({0, 0.01 * k, 0.1, -10.0, 0.0, 0.0});
  return {Simulation(scene), scene.duration};
}

using DisksOverWalls = Journals;

TEST_F(DisksOverWalls, AreSaidOfTheFirstAndAtEachDoubling)
{
  auto run = flownOver(5);
  for (int k = 0; k <= 6; ++k)
  {
    run.advanceTo(0.0005 + 0.001 * k);
    journal.look(run);
    const std::size_t lines = warned.size();
    journal.look(run);
    EXPECT_EQ(warned.size(), lines) << "the same again";
  }
  ASSERT_EQ(warned.size(), 3u);
  EXPECT_EQ(warned[0].substr(0, 4), "1 of");
  EXPECT_EQ(warned[1].substr(0, 4), "2 of");
  EXPECT_EQ(warned[2].substr(0, 4), "4 of");
}

TEST_F(DisksOverWalls, AreCountedAnewInEachRun)
{
  auto run = flownOver(3);
  run.advanceTo(0.01);
  journal.look(run);
  EXPECT_EQ(newlyWarned().size(), 1u);
  auto next = flownOver(1);
  journal.look(next);
  EXPECT_EQ(newlyWarned().size(), 0u);
  next.advanceTo(0.01);
  journal.look(next);
  EXPECT_EQ(newlyWarned().size(), 1u);
}

TEST_F(DisksOverWalls, AreNotSaidOfOpenEnds)
{
  auto run = flownOver(3, Boundary::OPEN);
  run.advanceTo(0.01);
  EXPECT_EQ(run.now<BinFrame>().bins[0].left, 3u);
  journal.look(run);
  EXPECT_TRUE(warned.empty());
}

/// The user decides when a node's run ends, also where the scene says feed.on_choke: stop.
TEST_F(Journals, SaysOnceThatTheBaseIsChoked)
{
  SceneDefinition scene = chokedFeeder();
  scene.feed.on_choke = ChokeAction::STOP;
  follow(scene, 0.0, 0.5 * scene.duration, 1.0);
  ASSERT_EQ(warned.size(), 1u);
  EXPECT_EQ(warned[0].rfind("the base is choked: of ", 0), 0u) << warned[0];
}

class SlowPour : public Journals
{
protected:
  Lines at(double seconds, std::size_t poured, std::size_t of)
  {
    journal.pouring(poured, of,
                    Journal::Clock::time_point(std::chrono::duration_cast<Journal::Clock::duration>(
                        std::chrono::duration<double>(seconds))));
    return newlySaid();
  }
};

TEST_F(SlowPour, IsSaidWhenItHasLastedForAPeriod)
{
  EXPECT_EQ(at(100.0, 0, 9000), Lines());
  EXPECT_EQ(at(101.9, 1000, 9000), Lines());
  EXPECT_EQ(at(102.1, 2000, 9000), Lines{"2000 of 9000 disks poured"});
  EXPECT_EQ(at(104.0, 3000, 9000), Lines());
  EXPECT_EQ(at(104.2, 4000, 9000), Lines{"4000 of 9000 disks poured"});
}

/// The pour of a reset, long after the one at the start.
TEST_F(SlowPour, BeginsAnewWithAnotherPour)
{
  for (const double start : {0.0, 60.0, 120.0})
  {
    EXPECT_EQ(at(start, 0, 1500), Lines());
    EXPECT_EQ(at(start + 1.0, 1000, 1500), Lines());
  }
  EXPECT_EQ(at(180.0, 0, 9000), Lines());
  EXPECT_EQ(at(182.5, 1000, 9000), Lines{"1000 of 9000 disks poured"});
}
}  // namespace
}  // namespace ratchet_sieve
