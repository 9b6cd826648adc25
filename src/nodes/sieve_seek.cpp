#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include "node_options.h"
#include "ratchet_sieve/ros/seek_node.h"

namespace
{
constexpr const char* HELP =
    "Seeks the inclination at which a sieve separates best, while it runs and is fed: commands one over\n"
    "~inclination_setpoint of the sieve, counts what leaves, compares, goes on from the better one, and\n"
    "watches the best when it is found.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_seek [--help | --version] [ROS ARGUMENT...]\n"
    "\n"
    "Publishes each trial on ~trials (ratchet_sieve/SeekTrial). Parameters; times are simulated:\n"
    "  ~sieve                   name of the sieve's node (sieve)\n"
    "  ~inclination/start       to begin at [rad] (where the sieve is)\n"
    "  ~inclination/min, max    that are tried [rad] (the sieve's own limits)\n"
    "  ~inclination/step        first step [rad] (0.1)\n"
    "  ~inclination/resolution  least step [rad] (0.02)\n"
    "  ~dwell                   from when an inclination is reached until counting begins [s] (4)\n"
    "  ~window                  time over which it is counted, at least [s] (4)\n"
    "  ~least_disks             of each species in a window, which is prolonged for them (100)\n"
    "  ~longest_window          [s], though a species is kept back (60)\n"
    "  ~confidence              standard errors by which one has to be better, or is tried again (1.5)\n"
    "  ~most_trials             at one inclination before one is taken all the same (3)\n"
    "  ~drop                    of Q below what was held, on which the search begins again (0.15)\n"
    "Exit status: 0 when it is stopped; 2 for a bad parameter.\n";
}  // namespace

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  if (answerOptions(argc, argv, "sieve_seek", HELP))
    return 0;
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
