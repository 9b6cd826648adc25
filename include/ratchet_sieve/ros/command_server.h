#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>

#include "ratchet_sieve/LockStep.h"
#include "ratchet_sieve/PourDisks.h"
#include "ratchet_sieve/ResetSimulation.h"
#include "ratchet_sieve/StepSimulation.h"
#include "ratchet_sieve/live/run_control.h"
#include "ratchet_sieve/live/setpoint.h"
#include "ratchet_sieve/ros/diagnostics.h"
#include "ratchet_sieve/ros/node_parameters.h"
#include "ratchet_sieve/ros/waiting_calls.h"

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

  /// Applies and logs the setpoints received on topics. To be called after callbacks were served.
  void deliverSetpoints();

private:
  /// The throttled log of one quantity's setpoints.
  struct SetpointLog
  {
    LogThrottle taken;
    LogThrottle refused;
  };

  void takeSetpoint(const Setpoint& setpoint, const std_msgs::Float64& message);
  void command(Quantity quantity, double value);
  void commandAll();
  bool pause(std_srvs::Empty::Request&, std_srvs::Empty::Response&);
  bool unpause(std_srvs::Empty::Request&, std_srvs::Empty::Response&);
  bool resetWorld(std_srvs::Empty::Request&, std_srvs::Empty::Response&);
  bool reset(ResetSimulation::Request& request, ResetSimulation::Response& response);
  bool step(StepSimulation::Request& request, StepSimulation::Response& response);
  bool lockStep(LockStep::Request& request, LockStep::Response& response);
  bool pour(PourDisks::Request& request, PourDisks::Response& response);

  RunControl& control_;
  Diagnostics& diagnostics_;
  RunControl::Stride stride_;
  std::function<void()> time_changed_;
  std::string frame_id_;                      ///< of messages in service responses
  std::array<SetpointLog, QUANTITIES> logs_;  ///< in the order of Quantity
  SetpointInbox inbox_;
  WaitingCalls interrupting_;  ///< calls of services that end a step
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace ratchet_sieve
