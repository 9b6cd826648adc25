#include "ratchet_sieve/recording/headless_run.h"

#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "ratchet_sieve/recording/run_warnings.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

TEST(HeadlessRun, GoesToTheScenesDuration)
{
  Simulation simulation(smallRing());
  const double energy = simulation.energy();
  const RunOutcome outcome = runToEnd(simulation, {});
  EXPECT_EQ(outcome.end, RunEnd::COMPLETED);
  EXPECT_EQ(simulation.time(), 1.0);
  EXPECT_EQ(outcome.progress.energy_start, energy);
  EXPECT_EQ(outcome.progress.through_base, 0u);
  ASSERT_EQ(outcome.warnings.size(), 1u);
  EXPECT_EQ(outcome.warnings[0],
            "mean_vx_stderr of A, B is null: 1 s after settle are too short to tell the "
            "error; a duration of about 2.1 s may do [unknown-error]");
}

TEST(HeadlessRun, EndsAtAChokedBaseIfItsSceneSaysSo)
{
  SceneDefinition scene = chokedFeeder();
  scene.feed.on_choke = ChokeAction::STOP;
  Simulation choked(scene);
  const RunOutcome outcome = runToEnd(choked, {});
  EXPECT_EQ(outcome.end, RunEnd::CHOKED);
  ASSERT_EQ(outcome.warnings.size(), 2u);
  EXPECT_EQ(outcome.warnings[0].rfind("ended at ", 0), 0u) << outcome.warnings[0];
  EXPECT_EQ(outcome.warnings[1].rfind("the base is choked: of ", 0), 0u) << outcome.warnings[1];

  // Where it ends depends on neither its strides nor a checkpoint.
  Simulation halved(scene);
  halved.advanceTo(0.3 * choked.time());
  Simulation resumed(scene, halved.saveState());
  EXPECT_EQ(runToEnd(resumed, {}, {}).end, RunEnd::CHOKED);
  EXPECT_EQ(resumed.saveState(), choked.saveState());
  Simulation ended(scene, choked.saveState());
  EXPECT_EQ(runToEnd(ended, {}, {}).end, RunEnd::CHOKED);
  EXPECT_EQ(ended.time(), choked.time());

  scene.feed.on_choke = ChokeAction::RUN;
  scene.duration = choked.time();
  Simulation warned(scene);
  const RunOutcome run = runToEnd(warned, {});
  EXPECT_EQ(run.end, RunEnd::COMPLETED);
  EXPECT_NE(run.warnings.back().find("; feed.on_choke: stop ends such a run"), std::string::npos);
}

TEST(HeadlessRun, IsNotChokedByABaseThatFillsUp)
{
  SceneDefinition scene = chokedFeeder();
  scene.base.frequency = 23.0;
  scene.base.teeth = 20;
  scene.feed.stretch = {0.0, 0.02};
  scene.feed.on_choke = ChokeAction::STOP;
  scene.duration = 3.0;
  Simulation simulation(scene);
  EXPECT_EQ(runToEnd(simulation, {}).end, RunEnd::COMPLETED);
  EXPECT_LT(simulation.bins()[0].counted() + simulation.bins()[1].counted(), 90u) << "it is still filling";
}

TEST(HeadlessRun, SaysHowManyDisksWentOverTheWalls)
{
  SceneDefinition scene = smallMixture();
  scene.boundary = Boundary::WALLED;
  scene.base.wall_height = 0.03;
  scene.gravity = 0.0;
  scene.duration = 0.1;
  scene.initial = {
      {0, 0.03, 0.04, -1.0, 0.0, 0.0}, {0, 0.05, 0.05, 1.0, 0.0, 0.0}, {0, 0.06, 0.06, 1.0, 0.0, 0.0}};
  Simulation simulation(scene);
  const RunOutcome outcome = runToEnd(simulation, {});
  ASSERT_EQ(outcome.warnings.size(), 2u) << "it is also too short for errors";
  EXPECT_EQ(outcome.warnings[1],
            "3 of the disks went over the walls, which are 0.03 m high: 1 to the left, "
            "2 to the right; base.wall_height makes them higher [over-walls]");
}

TEST(HeadlessRun, StopsWhenAskedAndSaysWhere)
{
  Simulation simulation(smallRing());
  CollectingSink sink;
  RunWatchers watchers;
  watchers.frames = {{&sink}};
  int looks = 0;
  watchers.progress = [&looks](const Simulation&) { ++looks; };
  watchers.stop_wanted = [&simulation] { return simulation.time() >= 0.25; };
  const RunOutcome outcome = runToEnd(simulation, watchers);
  EXPECT_EQ(outcome.end, RunEnd::STOPPED);
  EXPECT_LT(simulation.time(), 1.0);
  ASSERT_EQ(outcome.warnings.size(), 1u);
  EXPECT_EQ(outcome.warnings[0].rfind("stopped at 0.", 0), 0u) << outcome.warnings[0];
  EXPECT_EQ(sink.particles.back().time, simulation.time());
  EXPECT_GT(looks, 15);
}

TEST(HeadlessRun, ReportsAnEnergyBeyondTheMachinesScale)
{
  // An endless slope.
  SceneDefinition scene = smallRing();
  scene.base.inclination = 1.5;
  scene.contact.pair_collisions = false;
  scene.duration = 100.0;
  Simulation simulation(scene);
  const RunOutcome outcome = runToEnd(simulation, {});
  EXPECT_EQ(outcome.warnings, std::vector<std::string>{withId(energyText(simulation), "large-energy")});
}

/// A walled base 2 m wide: it may turn at 0.858 rad/s.
SceneDefinition wideScene()
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 100;
  scene.boundary = Boundary::WALLED;
  scene.base.wall_height = 0.5;
  return scene;
}

TEST(WallWarnings, NameTheRateTheWidthAndTheLimit)
{
  EXPECT_EQ(
      fastTurnText(wideScene(), 3.0),
      "limits/inclination/slew_rate = 3 rad/s: a walled base 2 m wide that turns faster than 0.858 rad/s may "
      "throw its disks over the walls, 0.5 m high");
}

TEST(WallWarnings, AreOfWalledBasesThatTurnTooFastAlone)
{
  EXPECT_EQ(fastTurnText(wideScene(), 0.857), "");
  SceneDefinition scene = wideScene();
  scene.base.teeth = 1;
  EXPECT_EQ(fastTurnText(scene, 3.0), "");
  for (const Boundary boundary : {Boundary::OPEN, Boundary::PERIODIC})
  {
    scene = wideScene();
    scene.boundary = boundary;
    EXPECT_EQ(fastTurnText(scene, 3.0), "");
  }
}

}  // namespace
}  // namespace ratchet_sieve
