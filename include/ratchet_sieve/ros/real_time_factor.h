#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <ros/node_handle.h>

namespace ratchet_sieve
{

/// ~real_time_factor, simulated over wall time (0: as fast as it goes), which may be changed while the node
/// runs. The first read asks the master, which from then on tells the node of changes: the other reads cost
/// no more than one into a map.
class RealTimeFactor
{
public:
  /// @param present as read at the start
  RealTimeFactor(const ros::NodeHandle& private_node, double present);

  /// Looks, if it is time to. @return the new factor where it has changed to a good one
  std::optional<double> changed();

  /// Why the parameter as it is now is refused: the last good one then stays. Empty if it is good.
  const std::string& refusal() const { return refusal_; }

private:
  using Clock = std::chrono::steady_clock;

  ros::NodeHandle node_;
  double present_;
  std::string refusal_;
  Clock::time_point last_look_;
};

}  // namespace ratchet_sieve
