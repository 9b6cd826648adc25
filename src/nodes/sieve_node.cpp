#include <atomic>
#include <cstdio>
#include <exception>
#include <memory>

#include <ros/ros.h>

#include "node_options.h"
#include "ratchet_sieve/ros/sieve_node.h"

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
  std::unique_ptr<SieveNode> node;
  try
  {
    node = std::make_unique<SieveNode>(private_node, stop);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_node: %s\n", error.what());
    return stop ? 0 : 2;
  }
  try
  {
    node->run();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_node: %s\n", error.what());
    return 1;
  }
  return 0;
}
