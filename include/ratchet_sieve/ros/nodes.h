#pragma once

#include <atomic>

#include <ros/node_handle.h>

namespace ratchet_sieve
{

/// Runs the node of a sieve, by its private parameters, until the scene's end, a shutdown or `stop`. One loop
/// in one thread serves callbacks, advances the run to the next time at which something is due, publishes,
/// and keeps in step with wall time. An error is printed on standard error.
/// @param stop set by a signal handler to end the run
/// @return the exit status: 0, 1 for an error in the run or its recording, 2 where it cannot begin
int runSieve(const ros::NodeHandle& private_node, const std::atomic<bool>& stop);

/// Displays a sieve from its topics until a shutdown, with the same ~markers and ~cloud as the sieve's own
/// node. The sieve may be a recording played by `rosbag play`: then this node publishes /tf as well, unless
/// the bag holds /tf. Reads ~sieve (the name of the sieve's node; default `sieve` in this node's namespace;
/// empty: the first one found), ~frame_prefix (if the sieve has its own) and ~rates/display [1/s of wall
/// time]. @throws ParameterError
void runDisplay(const ros::NodeHandle& private_node);

}  // namespace ratchet_sieve
