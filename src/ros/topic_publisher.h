#pragma once

#include <functional>
#include <map>
#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>

#include "node_parameters.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/recording/run.h"
#include "transform_publisher.h"

namespace ratchet_sieve
{

/// Publishes frames on ~particles, ~bins, ~base, ~statistics, ~observed, ~commands and ~scene (latched),
/// purity and recovery with the bins on ~purity, the joint with the base on ~joint_states, each disk that
/// leaves on ~exits, and what each sensor sends on the topic of its name, with the stamp of the measurement.
/// The base is also published on /tf, with a transform at the stamp of every message of the disks. Topics
/// without subscribers are skipped. A new subscriber gets the present state at once, also in a pause.
class TopicPublisher : public FrameSink
{
public:
  /// @param current returns the present run, also after a reset
  /// @param parameters frames of the messages and transforms, how fast the base turns, and the sensors
  /// @param clock is advanced to the stamp of every message; clock and transforms outlive this
  TopicPublisher(ros::NodeHandle private_node, const std::function<const Run&()>& current,
                 const NodeParameters& parameters, ClockPublisher& clock, TransformPublisher& transforms);

  bool wants(FrameKind kind) const override;
  void take(const AnyFrame& frame) override;
  void publish(const ExitRecord& exit);
  void publish(const Sensor& sensor, const Reading& reading);

private:
  bool isHeard(FrameKind kind) const { return publishers_.at(kind).getNumSubscribers() > 0; }
  template <typename Frame>
  void advertise(ros::NodeHandle& node);
  template <typename Frame>
  void publish(const Frame& frame);
  template <typename Make>
  void send(const ros::Publisher& publisher, double time, Make&& make);

  std::function<const Run&()> current_;
  FrameNames frames_;
  ClockPublisher& clock_;
  TransformPublisher& transforms_;
  std::map<FrameKind, ros::Publisher> publishers_;
  ros::Publisher exits_;
  ros::Publisher purity_;                          ///< with the bins
  ros::Publisher joint_states_;                    ///< with the base
  std::map<std::string, ros::Publisher> sensors_;  ///< by their names
  double turning_rate_;                            ///< slew rate of the inclination [rad/s]
};

}  // namespace ratchet_sieve
