#include "ratchet_sieve/recording/resimulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "node_parameters.h"
#include "ratchet_sieve/live/run_control.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "read_bags.h"
#include "recorder.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double STRIDE = 0.01;

/// A recorded run with random commands.
class RecordedRun
{
public:
  /// @param driven by drives that are not exact
  explicit RecordedRun(const SceneDefinition& scene, const std::string& bag, bool driven = false)
      : recorder_(bag, "/sieve", everyFrame()),
        control(YAML::Load(canonicalYaml(scene)), "scene", parameters(driven), recorder_)
  {
    recorder_.open();
    control.begin();
  }

  void step(double duration)
  {
    control.step(duration,
                 [this](double time)
                 {
                   control.advanceTo(std::min(time, control.run().time() + STRIDE));
                   return true;
                 });
  }

  /// Commands, pours, pauses and resets, with a short run in between.
  void drawOperation()
  {
    step(*rc::gen::inRange(1, 300) / 1237.0);
    const double share = *rc::gen::inRange(0, 1000) / 999.0;
    switch (*rc::gen::inRange(0, 8))
    {
      case 0:
        return control.command(Quantity::INCLINATION, 0.3 * share);
      case 1:
        return control.command(Quantity::FREQUENCY, 40.0 * share);
      case 2:
        return control.command(Quantity::AMPLITUDE, 0.003 * share);
      case 3:
        return expect(control.pour(share < 0.5 ? "A" : "B", 1 + static_cast<std::size_t>(3.0 * share),
                                   share < 0.3 ? std::optional(Stretch{0.01 * share, 0.01}) : std::nullopt));
      case 4:
        control.unpause();
        return control.pause();
      case 5:
        return expect(control.fault("inclination", share < 0.5 ? "stuck" : "none"));
      case 6:
        ++bags;
        return expect(control.resetWorld());
      default:
        ++bags;
        return expect(control.reset(7, {"base.inclination=0.05"}, share < 0.5));
    }
  }

  int bags = 1;

private:
  static NodeParameters parameters(bool driven)
  {
    NodeParameters all;
    all.start_paused = true;
    all.slew_rates = {0.3, 20.0, 0.01};
    if (driven)
      all.drives = {{{0.2, 0.0, 0.0, {}, 0.03},
                     {0.0, 0.1, 0.01, {}, 0.0},
                     {0.1, 0.1, 0.0, {{10.0, 1.0}, {40.0, 0.5}}, 0.0}}};
    return all;
  }

  static RecordingParameters everyFrame()
  {
    RecordingParameters parameters;
    parameters.rates = FrameRates();
    return parameters;
  }

  static void expect(const Outcome& outcome) { EXPECT_TRUE(outcome.success) << outcome.message; }

  Recorder recorder_;

public:
  RunControl control;
};

void expectTheSame(const std::string& bag)
{
  Resimulation resimulation;
  readBags({bag}, resimulation);
  resimulation.finish();
  EXPECT_FALSE(resimulation.difference()) << bag << ": " << *resimulation.difference();
  EXPECT_GT(resimulation.frames(), 0u);
}

SceneDefinition fedMixture()
{
  SceneDefinition scene = smallMixture();
  scene.duration = 100.0;
  scene.settle = 0.1;
  scene.feed.rate = 20.0;
  scene.observe = observableNames();
  return scene;
}

RC_GTEST_PROP(Resimulation, givesEveryBagOfARunAgain, ())
{
  const ScratchDirectory scratch;
  RecordedRun run(*rc::gen::arbitrary<bool>() ? fedMixture() : smallRing(), scratch / "run.bag",
                  *rc::gen::arbitrary<bool>());
  const int operations = *rc::gen::inRange(1, 12);
  for (int k = 0; k < operations; ++k)
    run.drawOperation();
  run.step(0.2);
  run.control.end();
  expectTheSame(scratch / "run.bag");
  for (int bag = 2; bag <= run.bags; ++bag)
    expectTheSame(scratch / ("run_run" + std::to_string(bag) + ".bag"));
}

/// A short recorded run in memory, which tests can modify.
CollectingSink commandedRun(const SceneDefinition& scene = smallRing())
{
  const ScratchDirectory scratch;
  RecordedRun run(scene, scratch / "run.bag");
  run.step(0.3);
  run.control.command(Quantity::INCLINATION, 0.1);
  run.step(0.3);
  run.control.end();
  return readAll({scratch / "run.bag"});
}

/// The first difference when every `step`-th frame of one kind is repeated with the commands, as the program
/// says it.
template <typename Frame>
std::string differenceOf(const CollectingSink& recorded, const std::vector<Frame>& frames,
                         std::size_t step = 1)
{
  Resimulation resimulation;
  resimulation.take(recorded.scenes.at(0));
  auto command = recorded.commands.begin();
  for (std::size_t k = step - 1; k < frames.size(); k += step)
  {
    while (command != recorded.commands.end() && command->time <= frames[k].time)
      resimulation.take(*command++);
    resimulation.take(frames[k]);
  }
  resimulation.finish();
  return resimulation.difference().value_or("") +
         (resimulation.lacksCommands() ? ": cannot be repeated" : "");
}

std::string differenceOf(const CollectingSink& recorded)
{
  return differenceOf(recorded, recorded.particles);
}

TEST(Resimulation, findsALastBitThatWasChanged)
{
  CollectingSink recorded = commandedRun();
  ParticleFrame& frame = recorded.particles.at(20);
  frame.disks.at(2).vy = std::nextafter(frame.disks.at(2).vy, 10.0);
  const std::string difference = differenceOf(recorded);
  EXPECT_EQ(
      difference.rfind("at 0.33333333333333331 s the frames of particles differ: vy of disks[2] was ", 0), 0u)
      << difference;
}

/// As `rosbag filter` leaves them.
TEST(Resimulation, findsNothingWhereFramesWereTakenOut)
{
  SceneDefinition still = smallRing();
  still.base.amplitude = 0.0;
  SceneDefinition slow = smallRing();
  slow.base.frequency = 4.0;
  for (const SceneDefinition& scene : {smallRing(), still, slow})
  {
    const CollectingSink recorded = commandedRun(scene);
    EXPECT_EQ(differenceOf(recorded, recorded.statistics, 3), "");
  }
  CollectingSink recorded = commandedRun();
  recorded.statistics.at(5).window_start += 1e-3;
  EXPECT_NE(differenceOf(recorded, recorded.statistics, 3).find("window_start"), std::string::npos);
}

TEST(Resimulation, missesACommandAndADisk)
{
  CollectingSink recorded = commandedRun();
  ASSERT_EQ(recorded.commands.size(), 2u);  // the slew rates, and the setpoint
  recorded.commands.pop_back();
  EXPECT_NE(differenceOf(recorded).find("the frames of particles differ"), std::string::npos);
  recorded = commandedRun();
  recorded.particles.at(10).disks.pop_back();
  EXPECT_NE(differenceOf(recorded).find("3 disks were recorded, 4 were computed"), std::string::npos);
}

TEST(Resimulation, isOfOneRun)
{
  CollectingSink recorded = commandedRun();
  Resimulation resimulation;
  resimulation.take(recorded.scenes.at(0));
  resimulation.take(recorded.particles.at(0));
  SceneFrame scene = recorded.scenes.at(0);
  scene.time = 0.5;
  EXPECT_NO_THROW(resimulation.take(scene));
  scene.start_time = 0.5;
  EXPECT_THROW(resimulation.take(scene), std::invalid_argument);
}

TEST(Resimulation, refusesCommandsThatMakeNoSense)
{
  const CollectingSink recorded = commandedRun();
  const auto refuses =
      [&](CommandKind kind, std::vector<double> values, std::uint32_t species, std::uint32_t count = 1)
  {
    Resimulation resimulation;
    resimulation.take(recorded.scenes.at(0));
    resimulation.take(CommandFrame{0.0, kind, std::move(values), species, count});
    resimulation.take(recorded.particles.at(0));
    EXPECT_THROW(resimulation.finish(), std::invalid_argument);
  };
  refuses(CommandKind::INCLINATION, {}, 0);
  refuses(CommandKind::INCLINATION, {1.6}, 0);
  refuses(CommandKind::FREQUENCY, {-1.0}, 0);
  refuses(CommandKind::AMPLITUDE, {std::nan("")}, 0);
  refuses(CommandKind::SLEW_RATES, {0.1, 0.0, 0.1}, 0);
  refuses(CommandKind::SLEW_RATES, {0.1, 0.1}, 0);
  refuses(CommandKind::SLEW_RATES, {0.1, 1e14, 0.1}, 0);  // would keep the run busy forever
  refuses(CommandKind::FREQUENCY, {1e7}, 0);
  refuses(CommandKind::AMPLITUDE, {1e4}, 0);
  refuses(CommandKind::POUR, {}, 2);
  refuses(CommandKind::POUR, {}, 0, MOST_POURED + 1);
}

TEST(Resimulation, refusesARunThatBeganAtATimeThatIsNone)
{
  SceneFrame scene = commandedRun().scenes.at(0);
  for (const double start : {std::nan(""), -1.0, 0.5, std::numeric_limits<double>::infinity()})
  {
    scene.start_time = start;
    EXPECT_THROW(Resimulation().take(scene), std::invalid_argument) << start;
  }
}

/// A recording that `rosbag record` began late, or a file of a split one but the first.
TEST(Resimulation, saysThatTheBeginningOfTheRunIsMissing)
{
  CollectingSink recorded = commandedRun();
  while (recorded.particles.front().time < 0.45)
    recorded.particles.erase(recorded.particles.begin());
  recorded.commands.clear();
  EXPECT_EQ(differenceOf(recorded),
            "recording begins at 0.45 s; earlier commands are missing: cannot be repeated");
  recorded = commandedRun();
  recorded.particles.erase(recorded.particles.begin());
  recorded.particles.front().disks.at(0).vx += 1.0;
  EXPECT_NE(differenceOf(recorded).find("differ: vx of disks[0]"), std::string::npos)
      << "no later than frames are apart";
}

TEST(Resimulation, saysThatCommandsAreMissing)
{
  CollectingSink recorded = commandedRun();
  recorded.commands.pop_back();
  EXPECT_EQ(differenceOf(recorded, recorded.bases), "commands until 0.3 s are missing: cannot be repeated");
}

TEST(Resimulation, needsASceneAndAFrame)
{
  CollectingSink recorded = commandedRun();
  recorded.particles.clear();
  EXPECT_THROW(differenceOf(recorded), std::invalid_argument);
  EXPECT_THROW(Resimulation().take(BinFrame()), std::invalid_argument);
}
}  // namespace
}  // namespace ratchet_sieve
