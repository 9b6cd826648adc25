#include "ratchet_sieve/ros/display.h"

#include "ratchet_sieve/ros/particle_cloud.h"
#include "ratchet_sieve/ros/scene_markers.h"

namespace ratchet_sieve
{
namespace
{
using visualization_msgs::MarkerArray;

constexpr std::uint32_t QUEUE_SIZE = 2;
constexpr double STILL_PERIOD = 1.0;  // between pictures of a run that stands still [s]

/// Takes away what was drawn of an earlier run.
MarkerArray nothing()
{
  MarkerArray all;
  all.markers.resize(1);
  all.markers[0].action = visualization_msgs::Marker::DELETEALL;
  return all;
}

void append(MarkerArray& all, MarkerArray part)
{
  all.markers.insert(all.markers.end(), part.markers.begin(), part.markers.end());
}
}  // namespace

Display::Display(ros::NodeHandle private_node, double rate, TransformPublisher& transforms)
    : rate_(rate),
      transforms_(transforms),
      markers_(private_node.advertise<MarkerArray>("markers", QUEUE_SIZE)),
      cloud_(private_node.advertise<sensor_msgs::PointCloud2>("cloud", QUEUE_SIZE))
{
}

bool Display::due(double time) const
{
  const double waited = std::chrono::duration<double>(Clock::now() - last_shown_).count();
  return rate_ > 0.0 && waited >= (time == last_time_ ? STILL_PERIOD : 1.0 / rate_);
}

void Display::show(const LiveRun& run)
{
  const bool watched = markers_.getNumSubscribers() > 0 || cloud_.getNumSubscribers() > 0;
  if (!watched || !due(run.time()))
    return;
  last_shown_ = Clock::now();
  last_time_ = run.time();
  transforms_.clock().reach(run.time());
  const bool begun_anew = run.elapsed() < last_elapsed_;
  last_elapsed_ = run.elapsed();
  if (begun_anew)
    markers_.publish(nothing());
  if (markers_.getNumSubscribers() > 0)
    showMarkers(run);
  if (cloud_.getNumSubscribers() > 0)
    cloud_.publish(particleCloud(run.particles(), run.simulation().scene().species));
}

void Display::showMarkers(const LiveRun& run)
{
  const SceneDefinition& scene = run.simulation().scene();
  const BaseFrame base = run.base();
  const BinFrame bins = run.bins();
  // The base's markers stand in its own frame: where that is has to be known at their very stamp.
  transforms_.publish(base);
  MarkerArray all = baseMarkers(scene, base.time);
  append(all, diskMarkers(scene, run.particles()));
  append(all, binMarkers(scene, bins, base.base));
  append(all, captionMarkers(scene, bins, base.base));
  markers_.publish(all);
}

}  // namespace ratchet_sieve
