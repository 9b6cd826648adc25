#pragma once

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>

#include "ratchet_sieve/ResetSimulation.h"
#include "ratchet_sieve/StepSimulation.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/ros/conversions.h"
#include "waiting.h"

namespace ratchet_sieve
{

/// All frames received on one topic of a sieve.
template <typename Message>
class Topic
{
public:
  using Frame = decltype(toFrame(std::declval<Message>()));

  void subscribe(ros::NodeHandle& node, const std::string& name)
  {
    subscriber_ = node.subscribe<Message>(name, 10000,
                                          [this](const typename Message::ConstPtr& message)
                                          {
                                            stamps.push_back(message->header.stamp);
                                            frames.push_back(toFrame(*message));
                                          });
  }

  void unsubscribe() { subscriber_.shutdown(); }

  /// Waits for a frame of exactly this time. A sieve sends a new subscriber its present state.
  bool waitForTime(double time)
  {
    return waitFor([&] { return !frames.empty() && frames.back().time == time; });
  }

  void forget()
  {
    frames.clear();
    stamps.clear();
  }

  std::vector<Frame> frames;
  std::vector<ros::Time> stamps;

private:
  ros::Subscriber subscriber_;
};

/// A client of a paused sieve, which observes and commands it over topics and services.
class SieveClient
{
public:
  explicit SieveClient(const std::string& name) : node(name)
  {
    for (const char* quantity : {"inclination", "frequency", "amplitude"})
      setpoints[quantity] = node.advertise<std_msgs::Float64>(std::string(quantity) + "_setpoint", 10);
    scene.subscribe(node, "scene");
    particles.subscribe(node, "particles");
    bins.subscribe(node, "bins");
    base.subscribe(node, "base");
    statistics.subscribe(node, "statistics");
    observed.subscribe(node, "observed");
  }

  /// Waits for the first message of every topic and for a subscriber of every setpoint.
  bool connect()
  {
    return waitFor(
        [this]
        {
          bool heard = true;
          for (const auto& [name, publisher] : setpoints)
            heard = heard && publisher.getNumSubscribers() > 0;
          return heard && !scene.frames.empty() && !particles.frames.empty() && !bins.frames.empty() &&
                 !base.frames.empty() && !statistics.frames.empty();
        });
  }

  StepSimulation::Response step(double duration)
  {
    StepSimulation service;
    service.request.duration = duration;
    EXPECT_TRUE(ros::service::call(node.resolveName("step"), service));
    return service.response;
  }

  /// Steps and waits for all frames at the step's end.
  void stepAndSee(double duration)
  {
    const StepSimulation::Response stepped = step(duration);
    ASSERT_TRUE(stepped.success) << stepped.message;
    ASSERT_TRUE(particles.waitForTime(stepped.time));
    ASSERT_TRUE(bins.waitForTime(stepped.time));
    ASSERT_TRUE(base.waitForTime(stepped.time));
    ASSERT_TRUE(statistics.waitForTime(stepped.time));
  }

  ResetSimulation::Response reset(std::uint64_t seed = 0, const std::vector<std::string>& overrides = {},
                                  bool keep_time = false)
  {
    ResetSimulation service;
    service.request.seed = seed;
    service.request.overrides = overrides;
    service.request.keep_time = keep_time;
    EXPECT_TRUE(ros::service::call(node.resolveName("reset"), service));
    return service.response;
  }

  /// Resets, waits for the first frames of the new run, and forgets all frames before.
  void resetAndSee()
  {
    forget();
    const ResetSimulation::Response answer = reset();
    ASSERT_TRUE(answer.success) << answer.message;
    ASSERT_TRUE(particles.waitForTime(0.0) && bins.waitForTime(0.0) && base.waitForTime(0.0) &&
                statistics.waitForTime(0.0));
    particles.forget();
  }

  void forget()
  {
    particles.forget();
    bins.forget();
    base.forget();
    statistics.forget();
    observed.forget();
  }

  void publish(const std::string& quantity, double value)
  {
    std_msgs::Float64 message;
    message.data = value;
    setpoints[quantity].publish(message);
  }

  /// Publishes a setpoint, and waits until the base shows it.
  void command(const std::string& quantity, double value)
  {
    publish(quantity, value);
    ASSERT_TRUE(waitFor([&] { return commanded(quantity) == value; }));
  }

  double commanded(const std::string& quantity) const
  {
    const DriveState& last = base.frames.back().base;
    return quantity == "inclination" ? last.commanded_inclination
           : quantity == "frequency" ? last.commanded_frequency
                                     : last.commanded_amplitude;
  }

  /// Name of the sieve's node, without the slash.
  std::string name() const { return node.getNamespace().substr(1); }

  bool call(const std::string& service)
  {
    std_srvs::Empty nothing;
    return ros::service::call(node.resolveName(service), nothing);
  }

  ros::NodeHandle node;
  std::map<std::string, ros::Publisher> setpoints;
  Topic<SceneDescription> scene;
  Topic<ParticleStates> particles;
  Topic<BinCounts> bins;
  Topic<BaseState> base;
  Topic<SieveStatistics> statistics;
  Topic<Observations> observed;
};

}  // namespace ratchet_sieve
