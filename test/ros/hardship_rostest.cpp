#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>

#include "caught_log.h"
#include "child_node.h"
#include "collecting_sink.h"
#include "deaf_subscriber.h"
#include "node_log.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "sieve_client.h"
#include "small_scenes.h"
#include "statuses.h"
#include "truncated.h"

namespace ratchet_sieve
{
namespace
{
/// Freed memory that the address sanitizer keeps, to detect later use [bytes].
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t FREED_AND_KEPT = std::size_t{256} << 20;
#else
constexpr std::size_t FREED_AND_KEPT = 0;
#endif

constexpr double DOUBLE_NAN = std::numeric_limits<double>::quiet_NaN();
constexpr double DOUBLE_INFINITY = std::numeric_limits<double>::infinity();

/// Starts and stops nodes itself. The scene is on the parameter server, under each node's name.
class Hardship : public testing::Test
{
protected:
  /// Parameters of a node of this name.
  static void prepare(const std::string& name, bool start_paused)
  {
    XmlRpc::XmlRpcValue scene;
    ASSERT_TRUE(ros::param::get("/scene", scene));
    ros::param::set(name + "/scene", scene);
    ros::param::set(name + "/start_paused", start_paused);
    ros::param::set(name + "/exit_at_end", false);
  }

  static std::vector<std::string> named(const std::string& name) { return {"__name:=" + name.substr(1)}; }

  ScratchDirectory scratch_;
};

/// The address of a node according to the master; empty if the master does not know it.
std::string addressOf(const std::string& node)
{
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = node;
  return ros::master::execute("lookupNode", request, response, payload, false)
             ? static_cast<std::string&>(payload)
             : std::string();
}

/// All entries of the master under a name: publishers, subscribers and services, each with its nodes.
std::map<std::string, std::vector<std::string>> registered(const std::string& prefix)
{
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  EXPECT_TRUE(ros::master::execute("getSystemState", request, response, payload, false));
  std::map<std::string, std::vector<std::string>> all;
  const char* kinds[] = {"gives ", "takes ", "serves "};
  for (int kind = 0; kind < 3; ++kind)
    for (int k = 0; k < payload[kind].size(); ++k)
    {
      const std::string name = payload[kind][k][0];
      if (name.rfind(prefix, 0) == 0)
        for (int n = 0; n < payload[kind][k][1].size(); ++n)
          all[kinds[kind] + name].push_back(payload[kind][k][1][n]);
    }
  return all;
}

/// Waits until this process has lost all connections to the node.
bool isGone(SieveClient& sieve)
{
  return waitFor(
      [&]
      {
        int connected = 0;
        for (const auto& [name, publisher] : sieve.setpoints)
          connected += static_cast<int>(publisher.getNumSubscribers());
        return connected == 0;
      });
}

TEST_F(Hardship, aNodeThatWasKilledComesAgainUnderItsController)
{
  prepare("/phoenix", true);
  const auto runUnderCommand = [](SieveClient& sieve)
  {
    sieve.publish("inclination", 0.1);
    ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.1; }));
    sieve.stepAndSee(1.0);
  };
  SieveClient sieve("/phoenix");
  std::map<std::string, std::vector<std::string>> at_first;
  std::string first_address;
  ParticleFrame first_end;
  {
    ChildNode node("sieve_node", named("/phoenix"));
    ASSERT_TRUE(sieve.connect());
    runUnderCommand(sieve);
    first_end = sieve.particles.frames.back();
    at_first = registered("/phoenix/");
    first_address = addressOf("/phoenix");
    node.killAtOnce();
    EXPECT_EQ(node.wait(), -1);
  }
  ASSERT_TRUE(isGone(sieve));
  sieve.forget();
  sieve.scene.forget();
  ChildNode node("sieve_node", named("/phoenix"));
  ASSERT_TRUE(sieve.connect());
  EXPECT_EQ(sieve.base.frames.front().time, 0.0);
  EXPECT_EQ(sieve.base.frames.front().base.commanded_inclination, 0.0);
  runUnderCommand(sieve);
  EXPECT_TRUE(sameBits(sieve.particles.frames.back(), first_end));
  EXPECT_NE(addressOf("/phoenix"), first_address);
  EXPECT_EQ(registered("/phoenix/"), at_first);
  EXPECT_GE(at_first.size(), 15u);
}

TEST_F(Hardship, aScheduleBeginsAnewWithANodeThatComesAgain)
{
  prepare("/staged", true);
  XmlRpc::XmlRpcValue schedule;
  schedule[0]["time"] = 0.25;
  schedule[0]["inclination"] = 0.05;
  schedule[1]["time"] = 1000.0;  // never reached
  schedule[1]["inclination"] = 0.0;
  ros::param::set("/conductor/schedule", schedule);
  ros::param::set("/conductor/sieve", "/staged");
  ros::param::set("/staged/real_time_factor", 10.0);
  const NodeLog log("/conductor");
  ChildNode conductor("schedule.py", named("/conductor"));
  SieveClient sieve("/staged");
  for (int life = 0; life < 2; ++life)
  {
    ChildNode node("sieve_node", named("/staged"));
    ASSERT_TRUE(sieve.connect());
    const auto commanded = [&](const BaseFrame& frame) { return frame.base.commanded_inclination == 0.05; };
    ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().time >= 1.0; })) << "in life " << life;
    const auto& frames = sieve.base.frames;
    const auto first = std::find_if(frames.begin(), frames.end(), commanded);
    ASSERT_NE(first, frames.end()) << "in life " << life;
    EXPECT_GE(first->time, 0.25);
    node.killAtOnce();
    node.wait();
    ASSERT_TRUE(isGone(sieve));
    ASSERT_TRUE(waitFor([&] { return log.count("before the end of the schedule") == life + 1; }));
    sieve.forget();
    sieve.scene.forget();
  }
  EXPECT_TRUE(conductor.running());
}

TEST_F(Hardship, aScheduleThatIsOverDoesNotMindTheEnd)
{
  prepare("/finite", true);
  ros::param::set("/finite/exit_at_end", true);
  ros::param::set("/finite/scene/duration", 2.0);
  XmlRpc::XmlRpcValue schedule;
  schedule[0]["time"] = 0.25;
  schedule[0]["inclination"] = 0.05;
  ros::param::set("/usher/schedule", schedule);
  ros::param::set("/usher/sieve", "/finite");
  const NodeLog log("/usher");
  ChildNode usher("schedule.py", named("/usher"));
  SieveClient sieve("/finite");
  ChildNode first("sieve_node", named("/finite"));
  EXPECT_EQ(first.wait(), 0) << first.errors();
  ASSERT_TRUE(isGone(sieve));

  // The schedule has restarted.
  const auto before = log.count("the schedule is over");
  ChildNode second("sieve_node", named("/finite"));
  ASSERT_TRUE(waitFor([&] { return log.count("the schedule is over") > before; }));
  EXPECT_EQ(log.count("before the end of the schedule"), 0);
}

TEST_F(Hardship, aThousandSetpointsASecond)
{
  prepare("/flooded", false);
  const std::string bag = scratch_ / "run.bag";
  ros::param::set("/flooded/record", bag);
  const NodeLog log("/flooded");
  ChildNode node("sieve_node", named("/flooded"));
  SieveClient sieve("/flooded");
  ASSERT_TRUE(sieve.connect());

  constexpr int COUNT = 3000;
  constexpr double LAST = 0.123;
  int sent = 0;
  const ros::WallTimer sender = sieve.node.createWallTimer(
      ros::WallDuration(0.001),
      [&](const ros::WallTimerEvent&)
      {
        if (sent < COUNT)
          sieve.publish("inclination", ++sent < COUNT ? 0.1 * std::sin(0.01 * sent) : LAST);
      });
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == LAST; }));
  const double end = sieve.base.frames.back().time;
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().time > end + 0.5; }));
  EXPECT_EQ(sieve.base.frames.back().base.commanded_inclination, LAST);
  node.interrupt();
  EXPECT_EQ(node.wait(), 0) << node.errors();

  // As many frames of the bins as without setpoints, each at its time.
  CollectingSink recorded;
  readBag(bag, recorded);
  const double ended = recorded.bins.back().time;
  ASSERT_GE(recorded.bins.size(), static_cast<std::size_t>(60.0 * ended));
  for (std::size_t k = 0; k + 1 < recorded.bins.size(); ++k)
    ASSERT_EQ(recorded.bins[k].time, static_cast<double>(k) / 60.0);
  // One setpoint takes about 200 bytes: its own message and one of the base.
  rosbag::Bag file(bag);
  rosbag::View setpoints(file, rosbag::TopicQuery("/flooded/inclination_setpoint"));
  EXPECT_GT(setpoints.size(), 100u);
  EXPECT_LE(setpoints.size(), static_cast<std::size_t>(COUNT));
  EXPECT_LE(recorded.bases.size(), setpoints.size() + recorded.bins.size() + 1);
  EXPECT_LT(std::filesystem::file_size(bag), recorded.bins.size() * 3000 + COUNT * 500);
  ChildNode again("sieve_resimulate", {bag});
  EXPECT_EQ(again.wait(), 0) << again.errors();
  // One line per second, and some at the start.
  EXPECT_LT(log.lines.size(), 20 + 2 * static_cast<std::size_t>(ended));
}

TEST_F(Hardship, aBurstOfGarbage)
{
  prepare("/pelted", true);
  const NodeLog log("/pelted");
  ChildNode node("sieve_node", named("/pelted"));
  SieveClient sieve("/pelted");
  Statuses statuses(sieve.node);
  ASSERT_TRUE(sieve.connect());
  sieve.publish("inclination", 0.05);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.05; }));

  for (int k = 0; k < 20000; ++k)
    for (const double bad : {DOUBLE_NAN, DOUBLE_INFINITY, -DOUBLE_INFINITY, 1e308, -0.51, 0.51})
      sieve.publish("inclination", bad);
  sieve.publish("frequency", -1.0);
  ASSERT_TRUE(waitFor(
      [&]
      {
        const std::string& message = statuses["pelted: setpoints"].message;
        return message.find("frequency_setpoint -1 Hz refused") != std::string::npos &&
               message.find("inclination_setpoint 0.51 rad refused") != std::string::npos;
      }));
  EXPECT_EQ(statuses["pelted: setpoints"].level, diagnostic_msgs::DiagnosticStatus::WARN);
  sieve.stepAndSee(0.5);
  EXPECT_EQ(sieve.base.frames.back().base.inclination, 0.05);
  EXPECT_EQ(sieve.base.frames.back().base.frequency, 23.0);
  EXPECT_LT(log.lines.size(), 100u);

  // Then 100,000 legal ones: the last one is applied.
  for (int k = 0; k < 100000; ++k)
    sieve.publish("inclination", 1e-6 * k);
  sieve.publish("inclination", 0.25);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.25; }));
  sieve.publish("frequency", 20.0);
  ASSERT_TRUE(
      waitFor([&] { return statuses["pelted: setpoints"].level == diagnostic_msgs::DiagnosticStatus::OK; }));
  sieve.stepAndSee(0.5);
  EXPECT_EQ(sieve.base.frames.back().base.commanded_inclination, 0.25);
}

TEST_F(Hardship, messagesThatAreNoSetpoints)
{
  prepare("/puzzled", true);
  ChildNode node("sieve_node", named("/puzzled"));
  ros::NodeHandle handle("/puzzled");
  Topic<BaseState> base;
  base.subscribe(handle, "base");
  ASSERT_TRUE(waitFor([&] { return !base.frames.empty(); }));

  CaughtLog log;
  ros::Publisher words = handle.advertise<std_msgs::String>("amplitude_setpoint", 10);
  ASSERT_TRUE(waitFor([&] { return !log.with("wants topic /puzzled/amplitude_setpoint to have").empty(); }));
  EXPECT_EQ(words.getNumSubscribers(), 0u);
  words.shutdown();

  ros::Publisher stumps = handle.advertise<Truncated>("frequency_setpoint", 1000);
  ASSERT_TRUE(waitFor([&] { return stumps.getNumSubscribers() == 1; }));
  for (int k = 0; k < 100; ++k)
    stumps.publish(Truncated());
  stumps.shutdown();

  ros::Publisher amplitude = handle.advertise<std_msgs::Float64>("amplitude_setpoint", 10);
  ros::Publisher frequency = handle.advertise<std_msgs::Float64>("frequency_setpoint", 10);
  ASSERT_TRUE(
      waitFor([&] { return amplitude.getNumSubscribers() == 1 && frequency.getNumSubscribers() == 1; }));
  std_msgs::Float64 good;
  good.data = 0.001;
  amplitude.publish(good);
  good.data = 20.0;
  frequency.publish(good);
  EXPECT_TRUE(waitFor(
      [&]
      {
        const DriveState& seen = base.frames.back().base;
        return seen.commanded_amplitude == 0.001 && seen.commanded_frequency == 20.0;
      }));
  EXPECT_TRUE(node.running());
}

/// Memory of a process in RAM [bytes].
std::size_t residentMemory(pid_t process)
{
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::size_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST_F(Hardship, oneSubscriberHangsAndTheOtherGetsEveryMessage)
{
  // 4000 disks without disk-disk collisions: a message of about 270 kB.
  prepare("/talkative", true);
  ros::param::set("/talkative/scene/boundary", "periodic");
  ros::param::set("/talkative/scene/contact/pair_collisions", false);
  XmlRpc::XmlRpcValue species;
  ASSERT_TRUE(ros::param::get("/scene/species", species));
  for (int k : {0, 1})
    species[k]["count"] = 2000;
  ros::param::set("/talkative/scene/species", species);

  ChildNode node("sieve_node", named("/talkative"));
  SieveClient sieve("/talkative");
  ASSERT_TRUE(sieve.connect());
  const DeafSubscriber deaf("/talkative", "/talkative/particles",
                            ros::message_traits::MD5Sum<ParticleStates>::value());
  const DeafSubscriber deaf_too("/talkative", "/talkative/base",
                                ros::message_traits::MD5Sum<BaseState>::value());
  std::size_t memory_before = 0;
  for (int k = 0; k < 48; ++k)
  {
    sieve.particles.forget();
    sieve.stepAndSee(0.25);
    ASSERT_EQ(sieve.particles.frames.size(), 15u);
    for (int j = 0; j < 15; ++j)
      ASSERT_EQ(sieve.particles.frames[static_cast<std::size_t>(j)].time, (15 * k + j + 1) / 60.0);
    if (k == 7)
      memory_before = residentMemory(node.process());
  }
  // 600 messages were sent since: 160 MB if they were kept.
  EXPECT_LT(residentMemory(node.process()), memory_before + FREED_AND_KEPT + (50u << 20));
}

TEST_F(Hardship, theBaseTurnsThereAndBackAsFastAsItMay)
{
  prepare("/waving", true);
  XmlRpc::XmlRpcValue limits;
  limits["min"] = -1.5;
  limits["max"] = 1.5;
  limits["slew_rate"] = 15.0;
  ros::param::set("/waving/limits/inclination", limits);
  ros::param::set("/waving/scene/boundary", "periodic");
  ChildNode node("sieve_node", named("/waving"));
  SieveClient sieve("/waving");
  ASSERT_TRUE(sieve.connect());
  sieve.stepAndSee(0.5);
  double target = 0.5;
  for (int k = 0; k < 40; ++k, target = -target)
  {
    sieve.publish("inclination", target);
    ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == target; }));
    sieve.stepAndSee(0.05 + 0.01 * (k % 5));
  }
  EXPECT_EQ(sieve.particles.frames.back().disks.size(), 30u);
  EXPECT_LT(sieve.statistics.frames.back().max_overlap, 1e-9 * 0.001);
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "hardship_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
