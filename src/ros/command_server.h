#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>
#include <std_srvs/Trigger.h>

#include "diagnostics.h"
#include "node_parameters.h"
#include "ratchet_sieve/LockStep.h"
#include "ratchet_sieve/PourBetween.h"
#include "ratchet_sieve/PourDisks.h"
#include "ratchet_sieve/ResetSimulation.h"
#include "ratchet_sieve/SetFault.h"
#include "ratchet_sieve/StepSimulation.h"
#include "ratchet_sieve/live/run_control.h"
#include "ratchet_sieve/live/setpoint.h"

namespace ratchet_sieve
{

/// Serves the node's services and setpoint topics.
class CommandServer
{
public:
  /// @param stride for ~step and ~lock_step; ends them early if a pause, resume or reset is waiting
  /// @param time_changed called after a jump of simulated time, a pause or a resume
  /// @param control, diagnostics outlive this
  CommandServer(ros::NodeHandle private_node, const NodeParameters& parameters, RunControl& control,
                Diagnostics& diagnostics, RunControl::Stride stride, std::function<void()> time_changed);

  /// Serves callbacks, waiting for them up to `wait` [s of wall time]; applies and logs the setpoints that
  /// came.
  void serve(double wait);

private:
  /// The throttled log of one quantity's setpoints. The first one of another publisher is told at the level
  /// INFO, the next ones at DEBUG.
  struct SetpointLog
  {
    LogThrottle taken;
    LogThrottle refused;
    std::string publisher;  ///< of the last setpoint
    std::string told;       ///< the publisher that was told last
  };

  void takeSetpoint(const Setpoint& setpoint, const ros::MessageEvent<const std_msgs::Float64>& event);
  void command(Quantity quantity, double value);
  void offerServices(ros::NodeHandle& private_node);
  template <typename Service, typename Handle>
  void offer(ros::NodeHandle& node, const std::string& name, const Handle& handle);
  bool resetWorld();
  void reset(const ResetSimulation::Request& request, ResetSimulation::Response& response);
  void lockStep(const LockStep::Request& request, LockStep::Response& response);

  RunControl& control_;
  Diagnostics& diagnostics_;
  RunControl::Stride stride_;
  std::function<void()> time_changed_;
  std::string frame_id_;                      ///< of messages in service responses
  std::array<SetpointLog, QUANTITIES> logs_;  ///< in the order of Quantity
  SetpointInbox inbox_;

  /// Calls of services that end a step. A queue of their own tells a step, which is served from the global
  /// queue, whether one waits. Outlives the services.
  ros::CallbackQueue interrupting_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace ratchet_sieve
