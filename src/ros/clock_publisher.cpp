#include "ratchet_sieve/ros/clock_publisher.h"

#include <thread>

#include <rosgraph_msgs/Clock.h>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
/// A message of /clock is out and taken within a few ms, also on a machine that has much to do.
constexpr std::chrono::milliseconds LEAP_IS_HEARD(100);
}  // namespace

ClockPublisher::ClockPublisher(ros::NodeHandle node, double rate, bool enabled)
    : period_(1.0 / rate), enabled_(enabled)
{
  if (enabled_)
    publisher_ = node.advertise<rosgraph_msgs::Clock>("/clock", 1);
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
  clock.clock = stampOf(time);
  shown_ = clock.clock;
  publisher_.publish(clock);
}

void ClockPublisher::reach(double time)
{
  const ros::Time stamp = stampOf(time);
  if (!enabled_ || stamp == shown_)
    return;
  const bool leaps_back = shown_ && stamp < *shown_;
  publish(time);
  if (leaps_back)
    std::this_thread::sleep_for(LEAP_IS_HEARD);
}

}  // namespace ratchet_sieve
