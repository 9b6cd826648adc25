#include "ratchet_sieve/ros/clock_publisher.h"

#include <algorithm>
#include <thread>

#include <rosgraph_msgs/Clock.h>

#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/ros/earlier_publisher.h"

namespace ratchet_sieve
{
namespace
{
constexpr const char* TOPIC = "/clock";

/// A message of /clock or /tf passes three threads on its way to a tf2 listener's buffer: a few ms, and some
/// tens of ms for each thread on an overloaded machine. tf2 gives no sign that it has arrived.
constexpr std::chrono::milliseconds ARRIVAL(250);

/// A small scene that runs as fast as it can makes ten thousand frames per second of wall time, more than
/// subscribers of /clock can process. Messages are in transit for about as long as this.
constexpr std::chrono::milliseconds SHORTEST_PERIOD(1);

/// The clock's message at a time. Never 0, which means "no time yet" in ROS: `rosbag record` ends with the
/// first message that it receives at 0, and ros::Time::waitForValid() would block while a run is paused
/// there.
ros::Time shownAt(double time)
{
  return std::max(stampOf(time), ros::TIME_MIN);
}
}  // namespace

ClockPublisher::ClockPublisher(ros::NodeHandle node, double rate, bool enabled)
    : period_(1.0 / rate), enabled_(enabled)
{
  if (!enabled_)
    return;
  publisher_ = node.advertise<rosgraph_msgs::Clock>(TOPIC, 1);
  other_ = earlierPublisher(TOPIC);
  if (!other_)
    return;
  enabled_ = false;
  publisher_.shutdown();
}

std::string ClockPublisher::otherText() const
{
  return *other_ +
         " already publishes /clock, so this node does not: its stamps are its own simulated "
         "time, not that of /clock";
}

void ClockPublisher::publishDue(double time)
{
  if (std::chrono::steady_clock::now() - last_ >= period_)
    publish(time);
}

void ClockPublisher::publish(double time)
{
  if (!enabled_)
    return;
  last_ = std::chrono::steady_clock::now();
  rosgraph_msgs::Clock clock;
  clock.clock = shownAt(time);
  shown_ = clock.clock;
  publisher_.publish(clock);
}

void ClockPublisher::reach(double time)
{
  const ros::Time stamp = shownAt(time);
  if (!enabled_ || stamp == shown_)
    return;
  const bool jumps_back = shown_ && stamp < *shown_;
  if (jumps_back)
    std::this_thread::sleep_until(transform_sent_ + ARRIVAL);
  else if (shown_ && std::chrono::steady_clock::now() - last_ < SHORTEST_PERIOD)
    return;
  publish(time);
  if (jumps_back)
    jumped_back_ = std::chrono::steady_clock::now();
}

void ClockPublisher::waitForTimeJump() const
{
  std::this_thread::sleep_until(jumped_back_ + ARRIVAL);
}

}  // namespace ratchet_sieve
