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

/// Largest real-time factor; for a faster run, use 0 (as fast as possible).
constexpr double MAX_REAL_TIME_FACTOR = 1e6;

/// The parameters of the node, except the scene. The comments give their names.
struct NodeParameters : RunParameters
{
  double real_time_factor = 1.0;  ///< ~real_time_factor at the start: see RealTimeFactor
  bool publish_clock = true;      ///< ~publish_clock: publish /clock, unless another node does
  bool exit_at_end = true;        ///< ~exit_at_end: exit at the end of the scene's duration, otherwise pause
  std::string record;             ///< ~record: path of the recorded bag; empty: no recording
  RecordingParameters recording;  ///< ~recording/: rates, and sizes of the files
  double display_rate = 30.0;     ///< ~rates/display: upper limit for markers and cloud [1/s of wall time]
  double clock_rate = 100.0;      ///< ~rates/clock [1/s of wall time]
  std::array<double, 3> mount{};  ///< ~mount/x, y, z: position of the base's foot in `world` [m]
  FrameNames frames;              ///< from ~frame_prefix and ~mount

  /// Whether the base's foot is elsewhere than in the origin of `world`.
  bool mountedElsewhere() const { return mount != std::array<double, 3>{}; }
};

/// Reads the limits and slew rates of each setpoint from a sieve's parameters, of this node or another.
/// @throws ParameterError
std::array<Setpoint, QUANTITIES> readSetpoints(ParameterReader& reader, SlewRates& slew_rates);

/// Reads ~frame_prefix. @param sieve name of the node that the frames belong to @throws ParameterError
std::string readFramePrefix(ParameterReader& reader, const std::string& sieve);

/// Reads the node's private parameters and warns of unknown ones. @throws ParameterError
NodeParameters readNodeParameters(const ros::NodeHandle& private_node);

}  // namespace ratchet_sieve
