#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include "process_start.h"
#include "ratchet_sieve/ros/nodes.h"

namespace
{
constexpr const char* HELP =
    "Draw a sieve from its topics, live or played from a bag: publish ~markers and ~cloud, and for a bag "
    "that holds no /tf also /tf.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_display [--help | --version] [ROS ARGUMENT...]\n"
    "\n"
    "Parameters (see launch/replay.launch):\n"
    "  ~sieve          name of the sieve's node; empty: the only sieve (default: sieve)\n"
    "  ~frame_prefix   prefix of its frames (default: derived from the name of the sieve's node)\n"
    "  ~rates/display  pictures per second [Hz of wall time] (default: 30)\n"
    "\n"
    "Exit status: 0 if it is stopped; 2 for a bad parameter.\n";
}  // namespace

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_display", HELP))
    return 0;
  writeLogByLines();
  try
  {
    ros::init(argc, argv, "sieve_display");
    runDisplay(ros::NodeHandle("~"));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_display: %s\n", error.what());
    return 2;
  }
  return 0;
}
