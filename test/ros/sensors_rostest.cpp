#include <algorithm>
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
constexpr double DELAY = 0.25;    // s, of all sensors: one reading

XmlRpc::XmlRpcValue tree(const std::vector<std::pair<std::string, XmlRpc::XmlRpcValue>>& entries)
{
  XmlRpc::XmlRpcValue value;
  for (const auto& [key, entry] : entries)
    value[key] = entry;
  return value;
}

/// A sensor with a key of its own.
XmlRpc::XmlRpcValue sensor(const std::string& key, double value)
{
  return tree({{"rate", 4}, {"delay", DELAY}, {key, value}});
}

class Sensed : public testing::Test
{
protected:
  Sensed()
      : started_("/sensed",
                 {{"sensors", tree({{"scale", sensor("noise", 0.01)},
                                    {"count", sensor("miss", 0.2)},
                                    {"level", sensor("noise", 1.0)}})},
                  {"actuators", tree({{"inclination", tree({{"dead_time", 1.0}, {"offset", 0.01}})}})},
                  {"record", scratch_ / "run.bag"},
                  {"real_time_factor", 2.0},
                  {"scene/duration", DURATION}})
  {
    using geometry_msgs::WrenchStamped;
    for (const std::string side : {"left", "right"})
    {
      listen<WrenchStamped>(side + "/scale", [](const auto& message) { return message.wrench.force.z; });
      listen<DiskCounts>(side + "/count",
                         [](const auto& message) { return message.count[0] + 0.01 * message.count[1]; });
    }
    listen<DeckLevel>("level", [](const auto& message) { return message.level; });
    EXPECT_TRUE(waitFor(
        [this]
        {
          return std::all_of(subscribers_.begin(), subscribers_.end(),
                             [](const auto& subscriber) { return subscriber.getNumPublishers() == 1; });
        }));
  }

  template <typename Message, typename Value>
  void listen(const std::string& topic, Value value)
  {
    sent_[topic];
    subscribers_.push_back(
        sieve_.node.subscribe<Message>(topic, 1000,
                                       [this, topic, value](const typename Message::ConstPtr& message)
                                       {
                                         // Those of the start may have come before the run's first frames.
                                         if (const double time = message->header.stamp.toSec(); time > 0.0)
                                           sent_[topic].emplace_back(time, value(*message));
                                       }));
  }

  /// Begins a run.
  void begin()
  {
    sieve_.call("pause_physics");
    sieve_.resetAndSee();
    for (auto& topic : sent_)
      topic.second.clear();
  }

  /// Waits until all have sent what is due at a time.
  bool waitForReadings(double time)
  {
    return waitFor(
        [&]
        {
          return std::all_of(sent_.begin(), sent_.end(),
                             [&](const auto& topic)
                             { return !topic.second.empty() && topic.second.back().first == time - DELAY; });
        });
  }

  void expectFault(const std::string& part, const std::string& fault, const std::string& why_not = "")
  {
    SetFault service;
    service.request.part = part;
    service.request.fault = fault;
    EXPECT_TRUE(ros::service::call(sieve_.node.resolveName("fault"), service));
    EXPECT_EQ(service.response.message, why_not);
    EXPECT_EQ(service.response.success, why_not.empty());
  }

  ScratchDirectory scratch_;
  StartedNode started_;
  SieveClient& sieve_ = started_.sieve;
  std::map<std::string, std::vector<std::pair<double, double>>> sent_;  ///< stamps and values, by topic
  std::vector<ros::Subscriber> subscribers_;
};

TEST_F(Sensed, readTheSameByStepsOfAnyLengthAndByItself)
{
  const auto sent = [this](double step)
  {
    begin();
    if (step == 0.0)
      EXPECT_TRUE(sieve_.call("unpause_physics"));
    else
      for (int k = 1; step * k <= DURATION; ++k)
        EXPECT_TRUE(sieve_.step(step).success);
    EXPECT_TRUE(waitForReadings(DURATION));
    return sent_;
  };
  const auto once = sent(0.25);
  EXPECT_EQ(once.at("level").size(), 11u);
  EXPECT_EQ(sent(1.5), once);
  EXPECT_EQ(sent(0.0), once);
}

TEST_F(Sensed, failAtTheExactTime)
{
  begin();
  ASSERT_TRUE(sieve_.step(0.5).success);
  expectFault("level", "stuck");
  ASSERT_TRUE(sieve_.step(0.75).success);
  ASSERT_TRUE(waitForReadings(1.25));
  const auto& level = sent_["level"];
  ASSERT_EQ(level.size(), 4u);
  EXPECT_NE(level[0].second, level[1].second);
  EXPECT_EQ(level[2].second, level[1].second);
  EXPECT_EQ(level[3].second, level[1].second);
  expectFault("left/count", "nan", "fault nan: must be one of none, stuck, dropout");
  expectFault("inclination", "off", "fault off: must be one of none, stuck");
  expectFault("camera", "nan",
              "part camera: must be one of inclination, frequency, amplitude, left/scale, right/scale, "
              "left/count, right/count, level");
  std_srvs::Trigger tare;
  EXPECT_TRUE(ros::service::call(sieve_.node.resolveName("left/scale/tare"), tare) && tare.response.success);
}

TEST_F(Sensed, drivesWaitAndTheRunIsRepeatedBitForBit)
{
  CommandMessage command;
  const ros::Subscriber commands = sieve_.node.subscribe<CommandMessage>(
      "commands", 1000, [&](const CommandMessage::ConstPtr& message) { command = *message; });
  sensor_msgs::JointState joint;
  const ros::Subscriber joints = sieve_.node.subscribe<sensor_msgs::JointState>(
      "joint_states", 1000, [&](const sensor_msgs::JointState::ConstPtr& message) { joint = *message; });
  ASSERT_TRUE(waitFor([&] { return commands.getNumPublishers() == 1 && !joint.name.empty(); }));
  const auto stepTo = [&](double duration, double time)
  {
    ASSERT_TRUE(sieve_.step(duration).success);
    ASSERT_TRUE(sieve_.base.waitForTime(time));
    ASSERT_TRUE(waitFor([&] { return joint.header.stamp == ros::Time(time); }));
  };
  const auto commanded = [&](double time, double inclination, double given)
  {
    return waitFor([&] { return command.time == time && command.kind == CommandMessage::INCLINATION; }) &&
           command.values == std::vector<double>{inclination, given};
  };
  stepTo(0.5, 0.5);
  EXPECT_EQ(sieve_.base.frames.back().base.commanded_inclination, 0.01);  // the offset
  sieve_.publish("inclination", 0.1);
  EXPECT_TRUE(commanded(0.5, 0.1, 0.01));
  stepTo(1.25, 1.75);
  EXPECT_TRUE(commanded(1.5, 0.1, 0.11));
  EXPECT_NEAR(joint.position[0], 0.035, 1e-12);
  EXPECT_EQ(joint.velocity[0], 0.1);
  expectFault("inclination", "stuck");
  stepTo(0.5, 2.25);
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
