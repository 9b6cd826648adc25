#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include "node_options.h"
#include "ratchet_sieve/ros/schedule_node.h"

namespace
{
constexpr const char* HELP =
    "Commands a sieve over its setpoint topics, at given simulated times.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_schedule [--help | --version] [ROS ARGUMENT...]\n"
    "\n"
    "Parameters: ~sieve, the name of the sieve's node, `sieve` by default; ~schedule, a list of\n"
    "{time: s, inclination: rad, frequency: Hz, amplitude: m}, times ascending, one of the three at least;\n"
    "~exit_at_end (false): end when the last entry was sent, or else play it again after a reset.\n"
    "A sieve that was started paused is set going once this node is connected to it.\n"
    "Exit status: 0 when it is over or stopped; 2 for a bad parameter.\n";
}  // namespace

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_schedule", HELP))
    return 0;
  ros::init(argc, argv, "sieve_schedule");
  try
  {
    ScheduleNode node(ros::NodeHandle("~"));
    ros::spin();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_schedule: %s\n", error.what());
    return 2;
  }
  return 0;
}
