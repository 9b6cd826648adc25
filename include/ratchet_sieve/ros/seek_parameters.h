#pragma once

#include <optional>
#include <string>

#include <ros/node_handle.h>

#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/seeking/inclination_search.h"
#include "ratchet_sieve/seeking/separation_trial.h"

namespace ratchet_sieve
{

/// The parameters of sieve_seek. The comments give their names.
struct SeekParameters
{
  std::string sieve;            ///< ~sieve: name of the sieve's node, resolved
  std::optional<double> start;  ///< ~inclination/start [rad]; nothing: the sieve's present inclination

  std::string goal_name;  ///< of the parameter ~goal, resolved

  /// ~goal, ~inclination/min, max (default: the sieve's limits), step, resolution; ~confidence, ~most_trials,
  /// ~drop
  SearchOptions search;

  TrialOptions trial;  ///< ~dwell, ~window, ~longest_window, ~least_disks
};

/// Reads the node's private parameters and the limits of the sieve from its parameters. Warns of unknown
/// parameters. @throws ParameterError
SeekParameters readSeekParameters(const ros::NodeHandle& private_node);

}  // namespace ratchet_sieve
