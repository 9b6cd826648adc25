#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include "node_options.h"
#include "ratchet_sieve/ros/schedule_node.h"

namespace
{
constexpr const char* HELP =
    "Command a sieve over its setpoint topics at given simulated times.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_schedule [--help | --version] [ROS ARGUMENT...]\n"
    "\n"
    "Parameters:\n"
    "  ~sieve        name of the sieve's node (default: sieve)\n"
    "  ~schedule     list of {time: [s], inclination: [rad], frequency: [Hz], amplitude: [m]}, with times\n"
    "                in ascending order and at least one quantity in each entry\n"
    "  ~exit_at_end  exit after the last entry; if false, repeat the schedule after a reset\n"
    "                (default: false)\n"
    "\n"
    "A sieve that was started paused is set running when this node is connected to it.\n"
    "\n"
    "Exit status: 0 at the end of the schedule or if it is stopped; 2 for a bad parameter.\n";
}  // namespace

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_schedule", HELP))
    return 0;
  writeLogByLines();
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
