#include "ratchet_sieve/ros/clock_publisher.h"

#include <rosgraph_msgs/Clock.h>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{

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
  publisher_.publish(clock);
}

}  // namespace ratchet_sieve
