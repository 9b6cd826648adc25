#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include "child_node.h"
#include "node_log.h"
#include "own_master.h"
#include "ratchet_sieve/PourDisks.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/scene_parameters.h"
#include "ratchet_sieve/ros/transform_publisher.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "sieve_client.h"
#include "small_scenes.h"
#include "statuses.h"

namespace ratchet_sieve
{
namespace
{
/// A sieve started paused by roslaunch, reset for each test; and a simulation of its scene for comparison.
class Node : public testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(sieve.connect());
    sieve.resetAndSee();
  }

  static SceneDefinition sceneOfNode()
  {
    const SceneParameter parameter = readSceneParameter(ros::NodeHandle("/sieve"));
    return sceneFromYaml(parameter.root, parameter.source).definition;
  }

  /// Sends a command and waits until the sieve's base shows it.
  void command(const std::string& quantity, double value, double DriveState::*commanded)
  {
    sieve.publish(quantity, value);
    ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.*commanded == value; }));
  }

  SieveClient sieve{"/sieve"};
};

TEST_F(Node, latchesItsScene)
{
  const SceneFrame& frame = sieve.scene.frames.back();
  EXPECT_EQ(frame.yaml, canonicalYaml(sceneOfNode()));
  EXPECT_EQ(frame.scene_hash, sceneHash(sceneOfNode()));
  EXPECT_EQ(frame.seed, sceneOfNode().seed);
}

TEST_F(Node, stepsAsTheSimulationDoesBitForBit)
{
  Simulation simulation(sceneOfNode());
  for (const double duration : {0.25, 0.1234567, 0.5})
    sieve.stepAndSee(duration);
  EXPECT_EQ(sieve.particles.frames.back().time, 0.25 + 0.1234567 + 0.5);
  ASSERT_GT(sieve.particles.frames.size(), 50u);
  for (std::size_t k = 0; k < sieve.particles.frames.size(); ++k)
  {
    const ParticleFrame& frame = sieve.particles.frames[k];
    simulation.advanceTo(frame.time);
    ASSERT_TRUE(sameBits(frame.disks, makeParticleFrame(simulation).disks)) << "at " << frame.time << " s";
    ASSERT_EQ(sieve.particles.stamps[k], ros::Time(frame.time));
  }
}

TEST_F(Node, followsASetpointAtItsSlewRate)
{
  command("inclination", 0.1, &DriveState::commanded_inclination);
  command("frequency", 25.0, &DriveState::commanded_frequency);
  command("amplitude", 0.0015, &DriveState::commanded_amplitude);
  sieve.stepAndSee(0.1);
  const DriveState moving = sieve.base.frames.back().base;
  EXPECT_NEAR(moving.inclination, 0.02, 1e-12);  // limits/inclination/slew_rate: 0.2
  EXPECT_NEAR(moving.frequency, 24.0, 1e-12);
  EXPECT_NEAR(moving.amplitude, 0.0018, 1e-15);
}

TEST_F(Node, saysThatACollapseStoppedIt)
{
  Statuses statuses(sieve.node);
  ASSERT_TRUE(sieve.reset(0, {"contact.min_rebound_speed=0", "contact.collapse_events=10000"}).success);
  const StepSimulation::Response answer = sieve.step(5.0);
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("inelastic collapse"), std::string::npos) << answer.message;
  EXPECT_LT(answer.time, 5.0);
  ASSERT_TRUE(waitFor(
      [&]
      {
        const auto& status = statuses["sieve: simulation"];
        return status.level == diagnostic_msgs::DiagnosticStatus::ERROR && status.message == answer.message;
      }));
}

TEST_F(Node, goesOnThroughACollapseAndWarns)
{
  Statuses statuses(sieve.node);
  ASSERT_TRUE(sieve
                  .reset(0, {"contact.min_rebound_speed=0", "contact.collapse_events=1000",
                             "contact.on_collapse=rebound"})
                  .success);
  EXPECT_TRUE(sieve.step(1.0).success);
  EXPECT_TRUE(waitFor(
      [&]
      {
        const auto& status = statuses["sieve: simulation"];
        return status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
               status.message.find("inelastic collapse") != std::string::npos;
      }));
}

TEST_F(Node, warnsOfASceneThatCannotBeMeantUntilAnotherRuns)
{
  Statuses statuses(sieve.node);
  const NodeLog log("/sieve");
  ASSERT_TRUE(waitFor([&] { return log.connected(); }));
  ASSERT_TRUE(sieve.reset(0, {"base.amplitude=2"}).success);
  EXPECT_TRUE(waitFor(
      [&]
      {
        const auto& status = statuses["sieve: scene"];
        return status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
               status.message.rfind("base.amplitude = 2 m: 100 times a tooth's width", 0) == 0;
      }));
  EXPECT_TRUE(waitFor([&] { return log.count("/mixture.yaml: base.amplitude = 2 m: ") == 1; }));
  EXPECT_EQ(statuses.value("sieve: scene", "size"),
            "30 disks, at rest a layer of about 0.00479 m, about 1 MB of memory");
  ASSERT_TRUE(sieve.reset().success);
  EXPECT_TRUE(
      waitFor([&] { return statuses["sieve: scene"].level == diagnostic_msgs::DiagnosticStatus::OK; }));
}

/// An endless slope.
TEST_F(Node, warnsOnceThatTheEnergyLeavesTheMachinesScale)
{
  Statuses statuses(sieve.node);
  const NodeLog log("/sieve");
  ASSERT_TRUE(waitFor([&] { return log.connected(); }));
  const std::string words = "implausibly large energy: at ";
  const std::vector<std::string> slope = {"base.inclination=1.5", "boundary=periodic",
                                          "contact.pair_collisions=false", "duration=200"};
  ASSERT_TRUE(sieve.reset(0, slope).success);
  EXPECT_TRUE(sieve.step(60.0).success);
  EXPECT_TRUE(sieve.step(60.0).success);
  EXPECT_TRUE(waitFor(
      [&]
      {
        const auto& status = statuses["sieve: simulation"];
        return status.level == diagnostic_msgs::DiagnosticStatus::WARN && status.message.rfind(words, 0) == 0;
      }));
  EXPECT_TRUE(waitFor([&] { return log.count(words) > 0; }));
  EXPECT_EQ(log.count(words), 1);
}

TEST_F(Node, warnsOfDisksThatGoOverTheWalls)
{
  Statuses statuses(sieve.node);
  ASSERT_TRUE(sieve.reset(0, {"boundary=walled", "base.wall_height=0.002", "base.teeth=2"}).success);
  EXPECT_TRUE(sieve.step(3.0).success);
  EXPECT_TRUE(waitFor(
      [&]
      {
        const auto& status = statuses["sieve: simulation"];
        return status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
               status.message.find("of the disks went over the walls, which are 0.002 m high") !=
                   std::string::npos;
      }));
}

TEST_F(Node, warnsOfAWalledBaseThatMayTurnTooFast)
{
  Statuses statuses(sieve.node);
  // Small gravity holds the disks less: at 0.01 m/s^2 a base may turn at no more than 0.11 rad/s.
  ASSERT_TRUE(sieve.reset(0, {"boundary=walled", "gravity=0.01"}).success);
  EXPECT_TRUE(waitFor(
      [&]
      {
        const auto& status = statuses["sieve: setpoints"];
        return status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
               status.message.find("limits/inclination/slew_rate = 0.2 rad/s") != std::string::npos;
      }));
}

TEST_F(Node, poursOnAndAnew)
{
  const std::size_t poured = sieve.bins.frames.back().bins.at(0).on_base;
  PourDisks pour;
  pour.request.species = "A";
  pour.request.count = 5;
  ASSERT_TRUE(ros::service::call("/sieve/pour", pour));
  EXPECT_TRUE(pour.response.success);
  ASSERT_TRUE(waitFor([&] { return sieve.bins.frames.back().bins.at(0).on_base == poured + 5; }));

  sieve.stepAndSee(0.25);
  ASSERT_TRUE(sieve.call("reset_world"));
  ASSERT_TRUE(waitFor([&] { return sieve.bins.frames.back().bins.at(0).on_base == poured; }));
  EXPECT_EQ(sieve.bins.frames.back().time, 0.25);
}

TEST_F(Node, failsToPlaceDisksAnewWhereTheBaseStandsAndGoesOn)
{
  Statuses statuses(sieve.node);
  const auto warns = [&]
  {
    const auto& status = statuses["sieve: simulation"];
    return status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
           status.message.rfind("reset_world: initial.0 overlaps the base", 0) == 0;
  };
  ASSERT_TRUE(sieve.reset(0, {"initial=[{species: A, x: 0.07, y: 0.0075}]"}).success);
  command("inclination", 0.1, &DriveState::commanded_inclination);
  sieve.stepAndSee(1.5);
  EXPECT_FALSE(sieve.call("reset_world"));
  EXPECT_TRUE(waitFor(warns));
  EXPECT_EQ(sieve.step(0.5).time, 2.0);
  EXPECT_TRUE(warns());
  ASSERT_TRUE(sieve.reset().success);
  EXPECT_TRUE(waitFor([&] { return !warns(); }));
}

TEST_F(Node, runsUntilItIsPausedAndThenStandsStill)
{
  ASSERT_TRUE(sieve.call("unpause_physics"));
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().time > 0.1; }));
  EXPECT_FALSE(sieve.step(0.1).success);
  ASSERT_TRUE(sieve.call("pause_physics"));
  const double start = sieve.step(0.125).time;
  EXPECT_EQ(sieve.step(0.125).time, start + 0.125);
}

TEST_F(Node, isTheClockAlsoWhilePaused)
{
  sieve.stepAndSee(0.75);
  std::vector<ros::Time> clocks;
  const ros::Subscriber clock = sieve.node.subscribe<rosgraph_msgs::Clock>(
      "/clock", 100,
      [&](const rosgraph_msgs::Clock::ConstPtr& message) { clocks.push_back(message->clock); });
  ASSERT_TRUE(waitFor([&] { return clocks.size() >= 5; }));
  for (const ros::Time& time : clocks)
    EXPECT_EQ(time, ros::Time(0.75));
}

TEST_F(Node, broadcastsWhereTheBaseIs)
{
  tf2_msgs::TFMessage last;
  const ros::Subscriber transforms = sieve.node.subscribe<tf2_msgs::TFMessage>(
      "/tf", 1000, [&](const tf2_msgs::TFMessage::ConstPtr& message) { last = *message; });
  ASSERT_TRUE(waitFor([&] { return !last.transforms.empty(); }));
  command("inclination", 0.1, &DriveState::commanded_inclination);
  sieve.stepAndSee(0.7);
  ASSERT_TRUE(waitFor([&] { return last.transforms.at(0).header.stamp == ros::Time(0.7); }));
  EXPECT_EQ(last.transforms, baseTransforms(sieve.base.frames.back()));
}

TEST_F(Node, takesAwayWhatAnotherSceneHasNot)
{
  visualization_msgs::MarkerArray last;
  const ros::Subscriber markers = sieve.node.subscribe<visualization_msgs::MarkerArray>(
      "markers", 10, [&](const visualization_msgs::MarkerArray::ConstPtr& message) { last = *message; });
  const auto bins = [&]
  {
    return std::count_if(last.markers.begin(), last.markers.end(),
                         [](const visualization_msgs::Marker& marker) { return marker.ns == "left_bin"; });
  };
  ASSERT_TRUE(waitFor([&] { return bins() > 0; }));
  ASSERT_TRUE(sieve.reset(0, {"boundary=periodic"}).success);
  ASSERT_TRUE(waitFor([&] { return !last.markers.empty() && bins() == 0; }));
  EXPECT_EQ(last.markers[0].action, visualization_msgs::Marker::DELETEALL);
}

TEST(BadScene, isToldWithFileAndLineUnderRoslaunch)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "bad.yaml";
  std::ofstream(path) << "species:\n  - {name: A, count: 1, radius: -1, mass: 0.001}\n";
  ChildNode launch("/usr/bin/env", {"roslaunch", "-p", std::to_string(freePort()), "ratchet_sieve",
                                    "sieve.launch", "scene:=" + path});
  launch.wait();
  EXPECT_NE(launch.errors().find("sieve_node: " + path + ":2: species.0.radius = -1: must be "),
            std::string::npos)
      << launch.errors();
}

/// For example if a launch file sets an additional key.
TEST(BadScene, isToldWithoutALineWhereTheFileIsGood)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "good.yaml";
  std::ofstream(path) << "species:\n  - {name: A, count: 1, radius: 0.001, mass: 0.001}\n";
  ros::param::set("/other/scene_file", path);
  ros::param::set("/other/scene/duration", -1.0);
  ChildNode node("sieve_node", {"__name:=other"});
  EXPECT_EQ(node.wait(), 2);
  EXPECT_EQ(node.errors().rfind("sieve_node: " + path + ": duration = -1: must be ", 0), 0u) << node.errors();
}

TEST(SceneOfANode, isTheFilesWithTheKeysThatWereSet)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "scene.yaml";
  std::ofstream(path)
      << "base: {teeth: 020}\nspecies:\n  - {name: NO, count: 1, radius: 0.001, mass: 0.001}\n";
  ros::param::set("/told/scene_file", path);
  ros::param::set("/told/scene/base/inclination", 0.1);
  ros::param::set("/told/scene/duration", 5);
  ros::param::set("/told/set", "{duration: 6, species.0.radius: 0.002}");
  ros::param::set("/told/seed", "18446744073709551615");
  const SceneParameter read = readSceneParameter(ros::NodeHandle("/told"));
  EXPECT_EQ(canonicalYaml(sceneFromYaml(read.root, read.source).definition),
            canonicalYaml(loadSceneFile(path, {"base.inclination=0.1", "duration=6", "species.0.radius=0.002",
                                               "seed=18446744073709551615"})
                              .definition));
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
