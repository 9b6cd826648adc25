#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include "node_options.h"
#include "ratchet_sieve/ros/display_node.h"

namespace
{
constexpr const char* HELP =
    "Shows a sieve from its topics alone, live or played from a bag: ~markers and ~cloud; of a bag also\n"
    "/tf, which a sieve that runs publishes by itself.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_display [--help | --version] [ROS ARGUMENT...]\n"
    "\n"
    "Parameters: ~sieve, the name of the sieve's node, `sieve` by default; empty: the sieve that there is.\n"
    "~frame_prefix of its frames, where it has one of its own.\n"
    "~rates/display, pictures per second of wall time, 30 by default. See launch/replay.launch.\n"
    "Exit status: 0 when it is stopped; 2 for a bad parameter.\n";
}  // namespace

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_display", HELP))
    return 0;
  ros::init(argc, argv, "sieve_display");
  try
  {
    DisplayNode node(ros::NodeHandle("~"));
    ros::spin();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_display: %s\n", error.what());
    return 2;
  }
  return 0;
}
