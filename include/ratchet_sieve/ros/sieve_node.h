#pragma once

#include <atomic>
#include <optional>

#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "ratchet_sieve/live/journal.h"
#include "ratchet_sieve/live/pacer.h"
#include "ratchet_sieve/ros/clock_publisher.h"
#include "ratchet_sieve/ros/command_server.h"
#include "ratchet_sieve/ros/display.h"
#include "ratchet_sieve/ros/node_parameters.h"
#include "ratchet_sieve/ros/real_time_factor.h"
#include "ratchet_sieve/ros/scene_parameters.h"
#include "ratchet_sieve/ros/topic_publisher.h"

namespace ratchet_sieve
{

/// The simulation node: one loop in one thread. It serves callbacks, advances the run to the next time at
/// which something is due, publishes, and keeps in step with wall time.
class SieveNode
{
public:
  /// Reads the private parameters and pours the scene.
  /// @param stop set by a signal handler to end the run; outlives this
  /// @throws SceneError, ParameterError, BagError, std::invalid_argument if disks overlap
  SieveNode(const ros::NodeHandle& private_node, const std::atomic<bool>& stop);

  /// Runs until the scene's end, a shutdown or `stop`, and closes the bag.
  /// @throws StallError, BagError
  void run();

private:
  SieveNode(const ros::NodeHandle& private_node, const SceneParameter& scene, const std::atomic<bool>& stop);

  bool stopped() const;
  bool ended() const;
  double waitUntilDue() const;
  void advance();
  void advanceTo(double time);
  bool stride(double time);
  void finish();
  void keepAlive();
  void watchSpeed();
  void watchPour(std::size_t poured, std::size_t of);
  void end();

  ros::NodeHandle node_;
  const std::atomic<bool>& stop_;
  NodeParameters parameters_;
  Journal journal_;
  Recorder recorder_;
  RunControl control_;
  RealTimeFactor real_time_factor_;
  Pacer pacer_;
  SpeedWatch speed_;
  ClockPublisher clock_;
  std::optional<tf2_ros::StaticTransformBroadcaster> own_world_;  ///< if the sieve has its own world frame
  TransformPublisher transforms_;
  TopicPublisher topics_;
  Display display_;
  Diagnostics diagnostics_;
  CommandServer commands_;
};

}  // namespace ratchet_sieve
