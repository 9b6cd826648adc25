#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include "ratchet_sieve/live/run_control.h"
#include "recorder.h"
#include "transform_publisher.h"

namespace ratchet_sieve
{

/// Largest rate of the display and of /clock [1/s of wall time].
constexpr double MAX_WALL_RATE = 1e3;

/// An illegal parameter. One line names it, its value and what is allowed.
struct ParameterError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Reads and checks a node's parameters, and keeps track of which were read.
class ParameterReader
{
public:
  explicit ParameterReader(const ros::NodeHandle& node) : node_(node) {}

  /// A finite number in [least, most]; `fallback` if the parameter is not set.
  /// @throws ParameterError
  double number(const std::string& name, double fallback, double least, double most);

  /// A whole number from 0 to `most`.
  std::size_t count(const std::string& name, std::size_t fallback, std::size_t most);

  /// @throws ParameterError
  bool flag(const std::string& name, bool fallback);

  /// @throws ParameterError
  std::string text(const std::string& name, const std::string& fallback);

  /// The full name, as in error messages.
  std::string fullName(const std::string& name) const { return node_.resolveName(name); }

  /// Parameters of the node that were never read, except those under `ignored`: most likely misspelt.
  std::set<std::string> unknown(const std::set<std::string>& ignored) const;

private:
  bool isSet(const std::string& name, XmlRpc::XmlRpcValue& value);
  template <typename T>
  T read(const std::string& name, const T& fallback, XmlRpc::XmlRpcValue::Type type,
         const std::string& allowed);

  ros::NodeHandle node_;
  std::set<std::string> asked_;
};

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

/// Reads ~frame_prefix. @param sieve name of the node that the frames belong to @throws ParameterError
std::string readFramePrefix(ParameterReader& reader, const std::string& sieve);

/// Reads the node's private parameters and warns of unknown ones. @throws ParameterError, SceneError
NodeParameters readNodeParameters(const ros::NodeHandle& private_node);

/// ~real_time_factor, simulated over wall time (0: as fast as possible), which may be changed while the node
/// runs. The first read subscribes to changes at the master, so later reads are local look-ups.
class RealTimeFactor
{
public:
  /// @param present the value read at the start
  RealTimeFactor(const ros::NodeHandle& private_node, double present);

  /// Reads the parameter if due. @return the new factor if it has changed to a legal one
  std::optional<double> changed();

  /// Why the parameter's present value is refused, while the last legal value stays; empty if it is legal.
  const std::string& refusal() const { return refusal_; }

private:
  using Clock = std::chrono::steady_clock;

  ros::NodeHandle node_;
  double present_;
  std::string refusal_;
  Clock::time_point last_look_;
};

}  // namespace ratchet_sieve
