#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <ros/node_handle.h>

namespace ratchet_sieve
{

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
