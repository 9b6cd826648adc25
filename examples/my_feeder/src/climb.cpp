// Climbs to the inclination at which a fed sieve separates best: scripts/climb.py in C++.
// Parameters: ~sieve (name of its node), ~step [rad], ~dwell [s]
#include <algorithm>
#include <cmath>
#include <string>

#include <my_feeder/Report.h>
#include <ratchet_sieve/BinCounts.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>

/// See climber.py.
struct Climber
{
  double step;   // rad
  double dwell;  // s
  double inclination = 0.0, time = 0.0, last = 0.0, direction = 1.0;
  double count_from = dwell;

  double take(const ratchet_sieve::BinCounts& bins)
  {
    if (bins.time < time)  // the sieve was reset
      *this = {step, dwell};
    time = bins.time;
    if (bins.window_start >= count_from && bins.window_separation_defined)
    {
      if (std::abs(bins.window_separation) < last)
        direction = -direction;
      last = std::abs(bins.window_separation);
      inclination = std::clamp(inclination + direction * step, -0.4, 0.4);
      count_from = bins.time + dwell;
    }
    return inclination;
  }
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "climb");
  ros::NodeHandle node, own("~");
  const std::string sieve = node.resolveName(own.param<std::string>("sieve", "sieve"));
  Climber climber{own.param("step", 0.03), own.param("dwell", 2.0)};
  const ros::Publisher setpoint = node.advertise<std_msgs::Float64>(sieve + "/inclination_setpoint", 1);
  const ros::Publisher reports = own.advertise<my_feeder::Report>("report", 10);
  const ros::Subscriber bins = node.subscribe<ratchet_sieve::BinCounts>(
      sieve + "/bins", 1,
      [&](const ratchet_sieve::BinCounts::ConstPtr& message)
      {
        my_feeder::Report report;
        std_msgs::Float64 command;
        command.data = report.inclination = climber.take(*message);
        report.bins = *message;
        setpoint.publish(command);
        reports.publish(report);
      },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  // See climb.py.
  std_srvs::Empty unpause;
  ros::service::waitForService(sieve + "/unpause_physics");
  ros::service::call(sieve + "/unpause_physics", unpause);
  ros::spin();
}
