#pragma once

#include <chrono>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/PointCloud2.h>

#include "ratchet_sieve/live/run_mirror.h"

namespace ratchet_sieve
{

/// The disks as a point cloud: x, y (0), z, radius [m, float32] and species (index, uint32).
/// For the display of very many disks; ParticleStates carries the full state.
/// @param species of the frame's scene
sensor_msgs::PointCloud2 particleCloud(const ParticleFrame& frame,
                                       const std::vector<SpeciesDefinition>& species,
                                       const std::string& frame_id);

/// Publishes pictures of a run on ~markers and ~cloud, at a rate of wall time that does not depend on the
/// run's speed.
class Display
{
public:
  /// @param rate upper limit [1/s of wall time]; 0: no display
  Display(ros::NodeHandle private_node, double rate);

  /// Whether a picture of this time is due; false without subscribers. While a run is paused, its picture is
  /// repeated once a second, for new subscribers. @param time simulated [s]
  bool due(double time) const;

  /// Publishes a picture, and deletes earlier markers that are not part of it. Topics without subscribers are
  /// skipped.
  /// @param frame_id of the picture
  void show(const Picture& picture, const std::string& frame_id);

private:
  using Clock = std::chrono::steady_clock;

  void showMarkers(const Picture& picture, const std::string& frame_id);

  double rate_;
  ros::Publisher markers_;
  ros::Publisher cloud_;
  Clock::time_point last_shown_;
  double last_time_ = -1.0;                           ///< simulated [s]
  std::set<std::pair<std::string, int>> last_names_;  ///< namespace and id of every marker that is drawn
};

}  // namespace ratchet_sieve
