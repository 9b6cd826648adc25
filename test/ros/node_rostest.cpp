#include <algorithm>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include "node_reports.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "scene_parameters.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
using Level = diagnostic_msgs::DiagnosticStatus;

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

  SieveClient sieve{"/sieve"};
  Statuses statuses{sieve.node};
};

TEST_F(Node, latchesItsScene)
{
  const SceneFrame& frame = sieve.scene.frames.back();
  EXPECT_EQ(frame.yaml, canonicalYaml(sceneOfNode()));
  EXPECT_EQ(frame.scene_hash, sceneHash(sceneOfNode()));
  EXPECT_EQ(frame.seed, sceneOfNode().seed);
}

/// Of the same disks as ~bins, and undefined where nothing has left.
TEST_F(Node, publishesThePurityOfTheBins)
{
  std::vector<Purity> seen;
  const ros::Subscriber subscriber = sieve.node.subscribe<Purity>(
      "purity", 100, [&](const Purity::ConstPtr& message) { seen.push_back(*message); });
  ASSERT_TRUE(waitFor([&] { return !seen.empty(); }));
  EXPECT_FALSE(seen.back().left.purity_defined || seen.back().right.recovery_defined.at(0));
  sieve.stepAndSee(8.0);
  const BinFrame& bins = sieve.bins.frames.back();
  ASSERT_TRUE(waitFor([&] { return seen.back().time == bins.time; }));
  const std::vector<SpeciesShares> shares = binShares(bins.bins);
  const auto expectShares = [&](const BinPurity& message, BinShares SpeciesShares::*bin)
  {
    for (std::size_t k = 0; k < shares.size(); ++k)
    {
      const BinShares& expected = shares[k].*bin;
      EXPECT_EQ(message.purity_defined, expected.number.purity.has_value());
      EXPECT_EQ(message.purity.at(k), expected.number.purity.value_or(0.0));
      EXPECT_EQ(message.purity_by_mass.at(k), expected.mass.purity.value_or(0.0));
      EXPECT_EQ(message.recovery_defined.at(k), expected.number.recovery.has_value());
      EXPECT_EQ(message.recovery.at(k), expected.number.recovery.value_or(0.0));
      EXPECT_EQ(message.recovery_by_mass.at(k), expected.mass.recovery.value_or(0.0));
    }
  };
  expectShares(seen.back().left, &SpeciesShares::left);
  expectShares(seen.back().right, &SpeciesShares::right);
  EXPECT_TRUE(seen.back().left.purity_defined || seen.back().right.purity_defined);
  EXPECT_EQ(seen.back().window_start, bins.window_start);
}

TEST_F(Node, tellsALateSubscriberHowFastItIs)
{
  sieve.stepAndSee(0.5);
  const double known = sieve.statistics.frames.back().real_time_factor;
  EXPECT_GT(known, 0.0);
  sieve.statistics.unsubscribe();
  sieve.statistics.forget();
  sieve.statistics.subscribe(sieve.node, "statistics");
  ASSERT_TRUE(sieve.statistics.waitForTime(0.5));
  EXPECT_EQ(sieve.statistics.frames.back().real_time_factor, known);
}

TEST_F(Node, followsASetpointAtItsSlewRate)
{
  sieve.command("inclination", 0.1);
  sieve.command("frequency", 25.0);
  sieve.command("amplitude", 0.0015);
  sieve.stepAndSee(0.1);
  const DriveState moving = sieve.base.frames.back().base;
  EXPECT_NEAR(moving.inclination, 0.02, 1e-12);  // limits/inclination/slew_rate: 0.2
  EXPECT_NEAR(moving.frequency, 24.0, 1e-12);
  EXPECT_NEAR(moving.amplitude, 0.0018, 1e-15);
}

/// A scene, how far it is stepped, and what /diagnostics then says.
struct Reported
{
  std::vector<std::string> overrides;
  double duration;
  const char* status;
  std::uint8_t level;
  const char* words;
};

TEST_F(Node, reportsWhatIsWrongWithARun)
{
  const Reported all[] = {
      {{"contact.min_rebound_speed=0", "contact.collapse_events=10000"},
       5.0,
       "simulation",
       Level::ERROR,
       "inelastic collapse"},
      {{"contact.min_rebound_speed=0", "contact.collapse_events=1000", "contact.on_collapse=rebound"},
       1.0,
       "simulation",
       Level::WARN,
       "inelastic collapse"},
      {{"base.amplitude=2"}, 0.0, "scene", Level::WARN, "base.amplitude = 2 m: 100 times a tooth's width"},
      {{"boundary=walled", "base.wall_height=0.002", "base.teeth=2"},
       3.0,
       "simulation",
       Level::WARN,
       "of the disks went over the walls, which are 0.002 m high"},
      // An endless slope.
      {{"base.inclination=1.5", "boundary=periodic", "contact.pair_collisions=false", "duration=200"},
       120.0,
       "simulation",
       Level::WARN,
       "implausibly large energy: at "},
      // Small gravity holds the disks less: at 0.01 m/s^2 a base may turn at no more than 0.11 rad/s.
      {{"boundary=walled", "gravity=0.01"},
       0.0,
       "setpoints",
       Level::WARN,
       "limits/inclination/slew_rate = 0.2 rad/s"}};
  for (const Reported& one : all)
  {
    ASSERT_TRUE(sieve.reset(0, one.overrides).success);
    if (one.duration > 0.0)
    {
      EXPECT_EQ(sieve.step(one.duration).success, one.level != Level::ERROR);
    }
    EXPECT_TRUE(statuses.waitFor(std::string("sieve: ") + one.status, one.level, one.words)) << one.words;
    ASSERT_TRUE(sieve.reset().success);
    EXPECT_TRUE(statuses.waitFor(std::string("sieve: ") + one.status, Level::OK)) << one.words;
  }
  EXPECT_EQ(statuses["sieve: scene"].hardware_id, "sieve");
  EXPECT_EQ(statuses.value("sieve: scene", "size"),
            "30 disks, at rest a layer of about 0.00479 m, about 1 MB of memory");
}

TEST_F(Node, failsToPlaceDisksAnewWhereTheBaseStandsAndGoesOn)
{
  ASSERT_TRUE(sieve.reset(0, {"initial=[{species: A, x: 0.07, y: 0.0075}]"}).success);
  sieve.command("inclination", 0.1);
  sieve.stepAndSee(1.5);
  EXPECT_FALSE(sieve.call("reset_world"));
  EXPECT_TRUE(statuses.waitFor("sieve: simulation", Level::WARN, "reset_world: initial.0 overlaps the base"));
  EXPECT_EQ(sieve.step(0.5).time, 2.0);
  ASSERT_TRUE(sieve.reset().success);
  EXPECT_TRUE(statuses.waitFor("sieve: simulation", Level::OK));
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

/// So slow that no frame is due during a test: 20 s of wall time are 20 us.
constexpr double STANDSTILL = 1e-6;

class Speed : public Node
{
protected:
  void SetUp() override
  {
    Node::SetUp();
    set(STANDSTILL, "1e-06");
  }
  void TearDown() override
  {
    sieve.call("pause_physics");
    set(1.0, "1");
  }

  void set(const XmlRpc::XmlRpcValue& factor, const std::string& shown)
  {
    ros::param::set("/sieve/real_time_factor", factor);
    ASSERT_TRUE(waitFor([&] { return asked() == shown; }));
  }

  std::string asked() { return statuses.value("sieve: speed", "real-time factor, requested"); }

  /// The next `count` times on /clock.
  std::vector<double> nextTimes(std::size_t count)
  {
    std::vector<double> times;
    const ros::Subscriber clock = sieve.node.subscribe<rosgraph_msgs::Clock>(
        "/clock", 1000,
        [&](const rosgraph_msgs::Clock::ConstPtr& message) { times.push_back(message->clock.toSec()); });
    EXPECT_TRUE(waitFor([&] { return times.size() >= count; }));
    return times;
  }
};

TEST_F(Speed, changesWhileItRunsAndStaysWhereTheParameterIsTakenAway)
{
  ASSERT_TRUE(sieve.call("unpause_physics"));
  EXPECT_LT(nextTimes(5).back(), 1e-3);
  ros::param::del("/sieve/real_time_factor");
  EXPECT_LT(nextTimes(3).back(), 1e-3);
  EXPECT_EQ(statuses["sieve: speed"].level, Level::OK);
  set(0, "0");                                // as `rosparam set` gives it: an integer
  ASSERT_TRUE(sieve.bins.waitForTime(20.0));  // the end of the run
}

TEST_F(Speed, refusesABadFactorAndKeepsTheLastGoodOne)
{
  XmlRpc::XmlRpcValue list;
  list[0] = 1.0;
  const std::vector<std::pair<XmlRpc::XmlRpcValue, std::string>> bad = {
      {-1.0, "-1"}, {std::numeric_limits<double>::quiet_NaN(), "nan"}, {"fast", "fast"}, {list, "{1}"}};
  ASSERT_TRUE(sieve.call("unpause_physics"));
  for (const auto& [value, shown] : bad)
  {
    ros::param::set("/sieve/real_time_factor", value);
    EXPECT_TRUE(statuses.waitFor(
        "sieve: speed", Level::WARN,
        "parameter /sieve/real_time_factor: " + shown + ": must be a number from 0 to 1e+06"))
        << shown;
    EXPECT_EQ(asked(), "1e-06");
  }
  set(0.5, "0.5");
  EXPECT_TRUE(statuses.waitFor("sieve: speed", Level::OK));
}

/// No machine simulates 30 disks at a million times real time.
TEST_F(Speed, saysThatItCannotKeepUp)
{
  ros::param::set("/sieve/real_time_factor", 1e6);
  ASSERT_TRUE(sieve.reset(0, {"boundary=periodic", "duration=1e6"}).success);
  ASSERT_TRUE(sieve.call("unpause_physics"));
  ASSERT_TRUE(statuses.waitFor("sieve: speed", Level::WARN, " times real time instead of 1e+06"));
  EXPECT_EQ(statuses["sieve: speed"].message.rfind("too slow: ", 0), 0u);
  EXPECT_GT(std::stod(statuses.value("sieve: speed", "wall time lost [s]")), 0.0);
  // It continues at the requested factor, not faster.
  set(STANDSTILL, "1e-06");
  const double before = nextTimes(1).back();
  EXPECT_LT(nextTimes(4).back() - before, 1e-3);
  EXPECT_TRUE(statuses.waitFor("sieve: speed", Level::OK));
}
}  // namespace
}  // namespace ratchet_sieve
