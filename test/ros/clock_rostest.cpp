#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/MarkerArray.h>

#include "caught_log.h"
#include "child_node.h"
#include "sieve_client.h"
#include "transform_publisher.h"

namespace ratchet_sieve
{
namespace
{
/// A paused sieve, reset for each test, observed from another program with its own time and tf buffer.
class Clock : public testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(sieve.connect());
    // The listener subscribes before time jumps, because during a reset it might get a transform twice.
    ASSERT_TRUE(waitFor([&] { return knows(ros::Time(0)); }));
    sieve.resetAndSee();
    ASSERT_TRUE(waitFor([&] { return knows(ros::Time(0)); }));
  }

  /// Checks that a transform exists at the stamp of every message of the disks.
  void expectTransformsOfAllParticles()
  {
    ASSERT_FALSE(sieve.particles.stamps.empty());
    for (const ros::Time& stamp : sieve.particles.stamps)
      ASSERT_TRUE(waitFor([&] { return knows(stamp); }, 5.0)) << "at " << stamp;
  }

  /// Steps, and waits until the listener has a time near the step's end. tf2 reads the clock only when a
  /// transform arrives, and detects a jump back in time by comparing with its last reading. The clock of a
  /// fast step may arrive after its transforms. So the transforms of a second step follow after the clock has
  /// arrived.
  void stepAndHear(double duration)
  {
    constexpr double SECOND_STEP = 0.02;
    sieve.stepAndSee(duration - SECOND_STEP);
    ASSERT_TRUE(waitFor([&] { return ros::Time::now() >= sieve.particles.stamps.back(); }));
    sieve.stepAndSee(SECOND_STEP);
    ASSERT_TRUE(waitFor([&] { return knows(sieve.particles.stamps.back()); }));
  }

  /// ros::Time(0) means "latest" to tf2: a message at time 0 is then transformed with the latest transform.
  bool knows(const ros::Time& stamp) const { return buffer.canTransform(FRAMES.world, FRAMES.base, stamp); }

  const FrameNames FRAMES;
  CaughtLog log;
  SieveClient sieve{"/sieve"};
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener{buffer};
};

TEST_F(Clock, transformsEveryMessageAtItsStamp)
{
  for (int k = 0; k < 4; ++k)
    sieve.stepAndSee(0.3);
  EXPECT_GT(sieve.particles.frames.size(), 70u);
  expectTransformsOfAllParticles();
  // The transform of that time, not interpolated between two others: A = 2 mm, f = 23 Hz.
  for (const ros::Time& stamp : sieve.particles.stamps)
  {
    const double expected = 0.002 * std::sin(2.0 * M_PI * 23.0 * stamp.toSec());
    EXPECT_NEAR(buffer.lookupTransform(FRAMES.mount, FRAMES.base, stamp).transform.translation.z, expected,
                1e-8)
        << "at " << stamp;
  }
  EXPECT_EQ(log.ofTf2(), std::vector<std::string>());
}

TEST_F(Clock, transformsOnAfterAReset)
{
  // Longer than tf2's buffer: older transforms are then rejected.
  ASSERT_NO_FATAL_FAILURE(stepAndHear(12.0));
  for (int k = 0; k < 2; ++k)
  {
    // With so many disks that the first message takes a while: the clock does not wait for it.
    sieve.forget();
    ASSERT_TRUE(
        sieve.reset(0, {"boundary=periodic", "contact.pair_collisions=false", "species.0.count=20000"})
            .success);
    ASSERT_TRUE(sieve.particles.waitForTime(0.0));
    // Not 0, at which `rosbag record` would end.
    ASSERT_TRUE(waitFor([&] { return ros::Time::now() == ros::TIME_MIN; }));
    ASSERT_TRUE(waitFor([&] { return knows(ros::Time(0)); })) << "after reset " << k;
    ASSERT_NO_FATAL_FAILURE(stepAndHear(0.3));
    expectTransformsOfAllParticles();
    EXPECT_TRUE(knows(ros::Time(1e-9))) << "the transforms of time 0 were lost";
    ASSERT_TRUE(sieve.reset().success);
    ASSERT_NO_FATAL_FAILURE(stepAndHear(11.0));
  }
  EXPECT_EQ(log.ofTf2(), std::vector<std::string>());
}

TEST_F(Clock, transformsOnAfterTheWorldWasReset)
{
  sieve.stepAndSee(0.1);
  expectTransformsOfAllParticles();
  const std::size_t jumps = log.count("jump back");  // from the reset before
  for (int k = 0; k < 2; ++k)
  {
    sieve.stepAndSee(0.1234);
    sieve.particles.forget();
    const double time = sieve.base.frames.back().time;
    ASSERT_TRUE(sieve.call("reset_world"));
    ASSERT_TRUE(sieve.particles.waitForTime(time));
    sieve.stepAndSee(0.2);
    expectTransformsOfAllParticles();
  }
  EXPECT_EQ(log.ofTf2(), std::vector<std::string>());
  EXPECT_EQ(log.count("jump back"), jumps);
}

TEST_F(Clock, hasNoTransformTwiceWhereADisplayLooksOn)
{
  ChildNode onlooker("sieve_display", {"__name:=onlooker"});
  std::optional<ros::Time> shown;
  const ros::Subscriber markers = sieve.node.subscribe<visualization_msgs::MarkerArray>(
      "/onlooker/markers", 10,
      [&](const visualization_msgs::MarkerArray::ConstPtr& picture)
      { shown = picture->markers.back().header.stamp; });
  for (int k = 0; k < 5; ++k)
  {
    sieve.stepAndSee(0.1);
    ASSERT_TRUE(waitFor([&] { return shown == sieve.particles.stamps.back(); }));
  }
  expectTransformsOfAllParticles();
  EXPECT_EQ(log.ofTf2(), std::vector<std::string>());
  onlooker.interrupt();
  EXPECT_EQ(onlooker.wait(), 0);
}

/// All times on /clock, from the first one on.
class ClockTopic
{
public:
  explicit ClockTopic(ros::NodeHandle& node)
      : subscriber_(node.subscribe<rosgraph_msgs::Clock>("/clock", 10000,
                                                         [this](const rosgraph_msgs::Clock::ConstPtr& message)
                                                         { times.push_back(message->clock); }))
  {
    EXPECT_TRUE(waitFor([this] { return !times.empty(); }));
  }

  int jumpsBack() const
  {
    int jumps = 0;
    for (std::size_t k = 1; k < times.size(); ++k)
      jumps += times[k] < times[k - 1] ? 1 : 0;
    return jumps;
  }

  std::vector<ros::Time> times;

private:
  ros::Subscriber subscriber_;
};

TEST_F(Clock, goesBackAtAResetAndNowhereElse)
{
  ClockTopic clock(sieve.node);
  sieve.stepAndSee(0.5);
  const std::size_t before = clock.times.size();
  ASSERT_TRUE(waitFor([&] { return clock.times.size() >= before + 3; }));  // also in a pause
  EXPECT_EQ(clock.times.back(), ros::Time(0.5));
  ASSERT_TRUE(sieve.call("unpause_physics"));
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().time > 1.0; }));
  ASSERT_TRUE(sieve.call("pause_physics"));
  ASSERT_TRUE(sieve.call("reset_world"));
  ASSERT_TRUE(sieve.call("unpause_physics"));
  const double paused = sieve.base.frames.back().time;
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().time > paused + 0.5; }));
  ASSERT_TRUE(sieve.call("pause_physics"));
  EXPECT_EQ(clock.jumpsBack(), 0);
  sieve.resetAndSee();
  sieve.stepAndSee(0.25);
  ASSERT_TRUE(waitFor([&] { return clock.times.back() == ros::Time(0.25); }));
  EXPECT_EQ(clock.jumpsBack(), 1);
}

TEST_F(Clock, isThereBeforeAMessageWithALaterStamp)
{
  // At a rate of four a second, nearly all clock messages come with the other messages.
  ClockTopic clock(sieve.node);
  ASSERT_TRUE(sieve.call("unpause_physics"));
  ASSERT_TRUE(
      waitFor([&] { return !sieve.particles.frames.empty() && sieve.particles.frames.back().time > 2.0; }));
  ASSERT_TRUE(sieve.call("pause_physics"));
  const std::set<ros::Time> shown(clock.times.begin(), clock.times.end());
  const auto known = [&](const ros::Time& stamp) { return shown.count(stamp) > 0; };
  const auto count = std::count_if(sieve.particles.stamps.begin(), sieve.particles.stamps.end(), known);
  // If several are due at the same time, only the newest is sent.
  EXPECT_GT(2 * static_cast<std::size_t>(count), sieve.particles.stamps.size());
}
}  // namespace
}  // namespace ratchet_sieve
