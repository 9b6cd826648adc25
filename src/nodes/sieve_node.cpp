#include <atomic>

#include <ros/ros.h>

#include "process_start.h"
#include "ratchet_sieve/ros/nodes.h"

namespace
{
constexpr const char* HELP =
    "Run a sieve as a ROS node: take setpoints and service calls, publish and record.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_node [--help | --version] [ROS ARGUMENT...]\n"
    "\n"
    "The parameter ~scene_file names the scene; the other parameters are in docs/node.md.\n"
    "\n"
    "Exit status: 0 at the end of the scene or if it is stopped; 2 for a bad scene or parameter; 1 for any\n"
    "other failure.\n";

std::atomic<bool> stop{false};

void requestStop(int)
{
  stop = true;
}
}  // namespace

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_node", HELP))
    return 0;
  writeLogByLines();
  // ROS's own signal handler would close the topics before the last messages are sent. While the node handle
  // waits for a master, a signal still ends the program at once.
  ros::init(argc, argv, "sieve", ros::init_options::NoSigintHandler);
  const ros::NodeHandle private_node("~");
  attendSignals(requestStop);
  return runSieve(private_node, stop);
}
