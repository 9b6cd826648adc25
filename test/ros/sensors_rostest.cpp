#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/Trigger.h>

#include "ratchet_sieve/DeckLevel.h"
#include "ratchet_sieve/DiskCounts.h"
#include "ratchet_sieve/SetFault.h"
#include "started_node.h"

namespace ratchet_sieve
{
namespace
{
using CommandMessage = MessageOf<CommandFrame>;

constexpr double DURATION = 3.0;  // s

XmlRpc::XmlRpcValue tree(const std::vector<std::pair<std::string, XmlRpc::XmlRpcValue>>& entries)
{
  XmlRpc::XmlRpcValue value;
  for (const auto& [key, entry] : entries)
    value[key] = entry;
  return value;
}

XmlRpc::XmlRpcValue noisySensors()
{
  return tree({{"scale", tree({{"rate", 4}, {"noise", 0.01}, {"delay", 0.3}})},
               {"count", tree({{"rate", 4}, {"miss", 0.2}})},
               {"level", tree({{"rate", 4}, {"noise", 1.0}})}});
}

XmlRpc::XmlRpcValue slowDrives()
{
  return tree({{"inclination", tree({{"dead_time", 1.0}, {"offset", 0.01}})}});
}

/// What each sensor sent: stamp and values, by topic.
class Readings
{
public:
  explicit Readings(ros::NodeHandle& node)
  {
    for (const char* side : {"left", "right"})
    {
      listen<geometry_msgs::WrenchStamped>(node, std::string(side) + "/scale",
                                           [](const auto& message)
                                           { return std::vector<double>{message.wrench.force.z}; });
      listen<DiskCounts>(node, std::string(side) + "/count",
                         [](const auto& message)
                         { return std::vector<double>(message.count.begin(), message.count.end()); });
    }
    listen<DeckLevel>(node, "level", [](const auto& message) { return std::vector<double>{message.level}; });
  }

  /// Waits until all have said what they measured until a time. @param delay of the scales [s]
  bool waitForTime(double time, double delay)
  {
    return waitFor(
        [&]
        {
          return std::all_of(sent.begin(), sent.end(),
                             [&](const auto& topic)
                             {
                               const bool late = topic.first.find("scale") != std::string::npos;
                               const double last = std::floor(4.0 * (late ? time - delay : time)) / 4.0;
                               return !topic.second.empty() && topic.second.back().first >= last;
                             });
        });
  }

  bool connected() const
  {
    return std::all_of(subscribers_.begin(), subscribers_.end(),
                       [](const ros::Subscriber& subscriber) { return subscriber.getNumPublishers() == 1; });
  }

  void forget()
  {
    for (auto& topic : sent)
      topic.second.clear();
  }

  std::map<std::string, std::vector<std::pair<double, std::vector<double>>>> sent;

private:
  template <typename Message, typename Values>
  void listen(ros::NodeHandle& node, const std::string& topic, Values values)
  {
    sent[topic];
    subscribers_.push_back(node.subscribe<Message>(
        topic, 1000,
        [this, topic, values](const typename Message::ConstPtr& message)
        { sent[topic].emplace_back(message->header.stamp.toSec(), values(*message)); }));
  }

  std::vector<ros::Subscriber> subscribers_;
};

class Sensed : public testing::Test
{
protected:
  Sensed()
      : started_("/sensed", {{"sensors", noisySensors()},
                             {"actuators", slowDrives()},
                             {"record", scratch_ / "run.bag"},
                             {"real_time_factor", 2.0},
                             {"scene/duration", DURATION}}),
        readings_(started_.sieve.node)
  {
    EXPECT_TRUE(waitFor([this] { return readings_.connected(); }));
  }

  /// Begins a run, with what the sensors say at its start.
  void begin()
  {
    started_.sieve.call("pause_physics");
    started_.sieve.resetAndSee();
    readings_.forget();
  }

  bool fault(const std::string& part, const std::string& fault, const std::string& why_not = "")
  {
    SetFault service;
    service.request.part = part;
    service.request.fault = fault;
    EXPECT_TRUE(ros::service::call(sieve_.node.resolveName("fault"), service));
    EXPECT_EQ(service.response.message, why_not);
    return service.response.success;
  }

  ScratchDirectory scratch_;
  StartedNode started_;
  SieveClient& sieve_ = started_.sieve;
  Readings readings_;
};

TEST_F(Sensed, readTheSameByStepsOfAnyLengthAndByItself)
{
  auto last = [this](double step)
  {
    begin();
    if (step == 0.0)
    {
      EXPECT_TRUE(sieve_.call("unpause_physics"));
    }
    else
    {
      for (int k = 1; step * k <= DURATION; ++k)
        EXPECT_TRUE(sieve_.step(step).success);
    }
    EXPECT_TRUE(readings_.waitForTime(DURATION, 0.3));
    auto sent = readings_.sent;
    // Those of the start may have come before the run's first frames.
    for (auto& topic : sent)
      topic.second.erase(topic.second.begin(), std::find_if(topic.second.begin(), topic.second.end(),
                                                            [](const auto& r) { return r.first > 0.0; }));
    return sent;
  };
  const auto once = last(0.25);
  ASSERT_EQ(once.at("level").size(), 12u);
  EXPECT_EQ(once.at("left/scale").size(), 10u);
  EXPECT_EQ(last(1.5), once);
  EXPECT_EQ(last(0.0), once);
}

TEST_F(Sensed, failAtTheExactTime)
{
  begin();
  ASSERT_TRUE(sieve_.step(0.5).success);
  EXPECT_TRUE(fault("level", "stuck"));
  ASSERT_TRUE(sieve_.step(0.5).success);
  ASSERT_TRUE(readings_.waitForTime(1.0, 0.3));
  const auto& level = readings_.sent["level"];
  EXPECT_EQ((level.end() - 1)->second, (level.end() - 3)->second);
  EXPECT_TRUE(fault("level", "nan"));
  ASSERT_TRUE(sieve_.step(0.25).success);
  ASSERT_TRUE(readings_.waitForTime(1.25, 0.3));
  EXPECT_TRUE(std::isnan(level.back().second[0]));
  EXPECT_FALSE(fault("left/count", "nan", "fault nan: must be one of none, stuck, dropout"));
  EXPECT_FALSE(fault("inclination", "off", "fault off: must be one of none, stuck"));
  EXPECT_FALSE(
      fault("camera", "nan",
            "part camera: must be one of inclination, frequency, amplitude, left/scale, right/scale, "
            "left/count, right/count, level"));
  std_srvs::Trigger tare;
  EXPECT_TRUE(ros::service::call(sieve_.node.resolveName("left/scale/tare"), tare) && tare.response.success);
}

TEST_F(Sensed, drivesWaitAndTheRunIsRepeatedBitForBit)
{
  std::vector<CommandMessage> commands;
  const ros::Subscriber listener = sieve_.node.subscribe<CommandMessage>(
      "commands", 1000, [&](const CommandMessage::ConstPtr& command) { commands.push_back(*command); });
  sensor_msgs::JointState joint;
  const ros::Subscriber joints = sieve_.node.subscribe<sensor_msgs::JointState>(
      "joint_states", 1000, [&](const sensor_msgs::JointState::ConstPtr& message) { joint = *message; });
  ASSERT_TRUE(waitFor([&] { return listener.getNumPublishers() == 1 && !joint.name.empty(); }));
  ASSERT_TRUE(sieve_.step(0.5).success);
  ASSERT_TRUE(waitFor([&] { return sieve_.base.frames.back().time == 0.5; }));
  EXPECT_EQ(sieve_.base.frames.back().base.commanded_inclination, 0.01);  // the offset
  sieve_.publish("inclination", 0.1);
  const auto asked = [&]
  {
    return !commands.empty() && commands.back().kind == CommandMessage::INCLINATION &&
           commands.back().time == 0.5;
  };
  ASSERT_TRUE(waitFor(asked));
  EXPECT_EQ(commands.back().values, (std::vector<double>{0.1, 0.01}));
  ASSERT_TRUE(sieve_.step(1.25).success);
  ASSERT_TRUE(waitFor([&] { return joint.header.stamp == ros::Time(1.75); }));
  EXPECT_EQ(commands.back().time, 1.5);
  EXPECT_EQ(commands.back().values, (std::vector<double>{0.1, 0.11}));
  EXPECT_NEAR(joint.position[0], 0.035, 1e-12);
  EXPECT_EQ(joint.velocity[0], 0.1);
  EXPECT_TRUE(fault("inclination", "stuck"));
  ASSERT_TRUE(sieve_.step(0.5).success);
  ASSERT_TRUE(waitFor([&] { return joint.header.stamp == ros::Time(2.25); }));
  EXPECT_NEAR(joint.position[0], 0.035, 1e-12);
  EXPECT_EQ(joint.velocity[0], 0.0);
  EXPECT_EQ(started_.end(), 0);
  ChildNode resimulation("sieve_resimulate", {scratch_ / "run.bag"});
  EXPECT_EQ(resimulation.wait(), 0) << resimulation.errors();
}

TEST(Sensors, thatAreUnknownEndTheNodeInOneLine)
{
  setParameters("/unknown", {{"sensors", tree({{"camera", tree({{"rate", 4}})}})}});
  ChildNode node("sieve_node", {"__name:=unknown"});
  EXPECT_EQ(node.wait(), 2);
  EXPECT_EQ(
      node.errors(),
      "sieve_node: parameter /unknown/sensors: camera: unknown key; must be one of count, level, scale\n");
}

}  // namespace
}  // namespace ratchet_sieve
