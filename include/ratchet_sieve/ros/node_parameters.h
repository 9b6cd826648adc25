#pragma once

#include <array>
#include <string>

#include <ros/node_handle.h>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/live/run_control.h"
#include "ratchet_sieve/ros/frame_names.h"
#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/ros/recorder.h"

namespace ratchet_sieve
{

/// A simulation that is asked for more than this wants 0, as fast as it goes.
constexpr double MAX_REAL_TIME_FACTOR = 1e6;

/// The parameters of the node but the scene. Names in comments are those of the parameters.
struct NodeParameters : RunParameters
{
  double real_time_factor = 1.0;  ///< ~real_time_factor at the start: see RealTimeFactor
  bool publish_clock = true;      ///< ~publish_clock: this node is the clock, if no other is
  bool exit_at_end = true;        ///< ~exit_at_end: end with the scene's duration, or else pause there
  std::string record;             ///< ~record: bag to record into; empty: none
  RecordingParameters recording;  ///< ~recording/: what of the run, how often, in how large files
  double display_rate = 30.0;     ///< ~rates/display: markers and cloud, at most [1/s of wall time]
  double wait_for_display = 0.0;  ///< ~wait_for_display: for so long a run waits for it [s of wall time]
  double clock_rate = 100.0;      ///< ~rates/clock [1/s of wall time]
  std::array<double, 3> mount{};  ///< ~mount/x, y, z: where in `world` the base's foot stands [m]
  FrameNames frames;              ///< by ~frame_prefix and ~mount

  /// Whether the base's foot stands elsewhere than in the origin of `world`.
  bool mountedElsewhere() const { return mount != std::array<double, 3>{}; }
};

/// Reads the limits and slew rates of each setpoint from the parameters of a sieve: the node's own, or
/// another's.
/// @throws ParameterError
std::array<Setpoint, QUANTITIES> readSetpoints(ParameterReader& reader, SlewRates& slew_rates);

/// ~frame_prefix. @param sieve name of the node whose frames it is for @throws ParameterError
std::string readFramePrefix(ParameterReader& reader, const std::string& sieve);

/// Reads the node's private parameters; warns of those that nobody knows. @throws ParameterError
NodeParameters readNodeParameters(const ros::NodeHandle& private_node);

}  // namespace ratchet_sieve
