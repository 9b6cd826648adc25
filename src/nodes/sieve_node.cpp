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
    "Parameters (default), with topics and services in docs/node.md:\n"
    "  ~scene_file              file of the scene, read as sieve_run reads it\n"
    "  ~scene                   keys of the scene as a tree; with a file they replace those of the file\n"
    "  ~set                     as YAML text with dotted keys: {base.inclination: 0.1}; after ~scene\n"
    "  ~seed                    a number, or its text where it is too large for a parameter (the scene's)\n"
    "  ~real_time_factor        simulated over wall time; 0: as fast as possible; may change (1)\n"
    "  ~start_paused            true or false (false)\n"
    "  ~exit_at_end             exit with the scene's duration; false: pause there (true)\n"
    "  ~threads                 threads of the engine, at most; 0: one per processor (0)\n"
    "  ~window                  over which ~bins counts what left lately [s of simulated time] (10)\n"
    "  ~record                  bag to record into (none)\n"
    "  ~recording/particles, bins, base, statistics, observed\n"
    "                           recorded frames per simulated second; 0: none (10, 60, 60, 10, 1)\n"
    "  ~recording/split_size, split_duration\n"
    "                           MB, simulated seconds after which a new file begins; 0: never (0, 0)\n"
    "  ~rates/particles, bins, base, statistics, observed\n"
    "                           messages per simulated second (60, 60, 60, 10, 1)\n"
    "  ~rates/display, clock    markers and cloud, /clock per second of wall time (30, 100)\n"
    "  ~publish_clock           publish /clock, unless another node does already (true)\n"
    "  ~frame_prefix            of the frames sieve_mount and sieve_base (the node's name)\n"
    "  ~mount/x, y, z           where in `world` the base's left foot is [m] (0)\n"
    "  ~limits/inclination/min, max, slew_rate   rad, rad/s (-0.5, 0.5, 0.1)\n"
    "  ~limits/frequency/min, max, slew_rate     Hz, Hz/s (0, 100, 10)\n"
    "  ~limits/amplitude/min, max, slew_rate     m, m/s (0, 0.01, 0.002)\n"
    "  ~sensors, ~actuators     what a real machine has, as trees: docs/node.md (none)\n"
    "\n"
    "Exit status: 0 at the end of the scene or if it is stopped; 2 for a bad scene or parameter; 1 for any "
    "other failure.\n";
}  // namespace

int main(int argc, char** argv)
try
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_node", HELP))
    return 0;
  writeLogByLines();
  // ROS's own signal handler would close the topics before the last messages are sent. While the node handle
  // waits for a master, a signal still ends the program at once.
  ros::init(argc, argv, "sieve", ros::init_options::NoSigintHandler);
  const ros::NodeHandle private_node("~");
  attendSignals();
  return runSieve(private_node, stop_requested);
}
catch (const ros::Exception& error)  // an illegal name
{
  std::fprintf(stderr, "sieve_node: %s\n", error.what());
  return 2;
}
