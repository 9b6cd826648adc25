#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include "node_options.h"
#include "ratchet_sieve/ros/seek_node.h"

namespace
{
constexpr const char* HELP =
    "Search for the inclination at which a running, fed sieve separates best: command an inclination over\n"
    "~inclination_setpoint of the sieve, count the disks that leave, compare Q (or ~goal) and continue from\n"
    "the better inclination. After the search, monitor the best one.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_seek [--help | --version] [ROS ARGUMENT...]\n"
    "\n"
    "Publishes every trial on ~trials (ratchet_sieve/SeekTrial).\n"
    "\n"
    "Parameters (all times are simulated):\n"
    "  ~sieve                   name of the sieve's node (default: sieve)\n"
    "  ~goal                    what is maximised: quality; purity:SPECIES:BIN, its share of the bin;\n"
    "                           recovery:SPECIES:BIN, the bin's share of what leaves of the species;\n"
    "                           flow:SPECIES:BIN, throughput (all that leaves) [1/s]. BIN: left or right;\n"
    "                           with :mass at the end by mass [kg/s] (default: quality)\n"
    "  ~inclination/start       first inclination [rad] (default: the present one)\n"
    "  ~inclination/min, max    range of the search [rad] (default: the limits of the sieve)\n"
    "  ~inclination/step        first step [rad] (default: 0.1)\n"
    "  ~inclination/resolution  last step [rad] (default: 0.02)\n"
    "  ~dwell                   wait after the inclination is reached, before counting [s] (default: 4)\n"
    "  ~window                  least time of counting [s] (default: 4)\n"
    "  ~least_disks             least number of disks of each species that are counted, for which the\n"
    "                           window is extended (default: 100)\n"
    "  ~longest_window          longest time of counting [s] (default: 60)\n"
    "  ~confidence              difference at which one inclination is better than another [standard\n"
    "                           errors]; at a smaller one the trial is repeated (default: 1.5)\n"
    "  ~most_trials             trials at one inclination before it is decided anyway (default: 3)\n"
    "  ~drop                    decrease at the best inclination that restarts the search; of flow and\n"
    "                           throughput relative to the best (default: 0.15)\n"
    "\n"
    "Exit status: 0 if it is stopped; 2 for a bad parameter.\n";
}  // namespace

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_seek", HELP))
    return 0;
  writeLogByLines();
  ros::init(argc, argv, "sieve_seek");
  try
  {
    SeekNode node(ros::NodeHandle("~"));
    ros::spin();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_seek: %s\n", error.what());
    return 2;
  }
  return 0;
}
