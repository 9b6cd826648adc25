#pragma once

#include <optional>
#include <string>

#include <ros/node_handle.h>

#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/seeking/inclination_search.h"
#include "ratchet_sieve/seeking/separation_trial.h"

namespace ratchet_sieve
{

/// The parameters of sieve_seek. Names in comments are those of the parameters.
struct SeekParameters
{
  std::string sieve;            ///< ~sieve: name of the sieve's node, resolved
  std::optional<double> start;  ///< ~inclination/start [rad]; nothing: where the sieve is

  /// ~inclination/min, max (the sieve's limits unless set), step, resolution; ~confidence, ~most_trials,
  /// ~drop
  SearchOptions search;

  TrialOptions trial;  ///< ~dwell, ~window, ~longest_window, ~least_disks
};

/// Reads the node's private parameters, and the limits of the sieve from that one's; warns of those that
/// nobody knows. @throws ParameterError
SeekParameters readSeekParameters(const ros::NodeHandle& private_node);

}  // namespace ratchet_sieve
