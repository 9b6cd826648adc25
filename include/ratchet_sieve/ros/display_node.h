#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "ratchet_sieve/live/run_mirror.h"
#include "ratchet_sieve/ros/display.h"
#include "ratchet_sieve/ros/transform_publisher.h"

namespace ratchet_sieve
{

/// Displays a sieve from its topics, with the same ~markers and ~cloud as the sieve's own node. The sieve may
/// be a recording played by `rosbag play`: then this node publishes /tf as well, unless the bag holds /tf.
class DisplayNode
{
public:
  /// Reads ~sieve (the name of the sieve's node; default `sieve` in this node's namespace; empty: the first
  /// one found), ~frame_prefix (if the sieve has its own) and ~rates/display [1/s of wall time]. @throws
  /// ParameterError
  explicit DisplayNode(const ros::NodeHandle& private_node);

private:
  DisplayNode(const ros::NodeHandle& private_node, const std::string& sieve, double rate);

  void search();
  void subscribe(const std::string& sieve);
  template <typename Message>
  void subscribe(const std::string& topic);
  /// @param publisher name of the node that published the frame @param frame_id of the message
  template <typename Frame>
  void see(const Frame& frame, const std::string& publisher, const std::string& frame_id);
  bool haveTransforms(const std::string& publisher);
  void warnOfSilence();
  void show();

  ros::NodeHandle node_;
  Display display_;
  TransformPublisher transforms_;
  RunMirror mirror_;
  std::string sieve_;             ///< name of its node, once known
  FrameNames frames_;             ///< of that sieve
  std::string publisher_;         ///< of the latest base
  bool have_transforms_ = false;  ///< whether it publishes /tf, too
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer search_timer_;
  ros::WallTimer silence_timer_;
  ros::WallTimer show_timer_;
};

}  // namespace ratchet_sieve
