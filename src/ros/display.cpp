#include "ratchet_sieve/ros/display.h"

#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/ros/particle_cloud.h"
#include "ratchet_sieve/ros/scene_markers.h"

namespace ratchet_sieve
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::uint32_t PICTURE_QUEUE_SIZE = 2;
constexpr double STILL_PERIOD = 1.0;  // between pictures of a paused run [s]

Marker deleteAll()
{
  Marker marker;
  marker.action = Marker::DELETEALL;
  return marker;
}
}  // namespace

Display::Display(ros::NodeHandle private_node, double rate)
    : rate_(rate),
      markers_(private_node.advertise<MarkerArray>("markers", PICTURE_QUEUE_SIZE)),
      cloud_(private_node.advertise<sensor_msgs::PointCloud2>("cloud", PICTURE_QUEUE_SIZE))
{
}

bool Display::due(double time) const
{
  const double waited = std::chrono::duration<double>(Clock::now() - last_shown_).count();
  return watched() && rate_ > 0.0 && waited >= (time == last_time_ ? STILL_PERIOD : 1.0 / rate_);
}

void Display::show(const Picture& picture, const std::string& frame_id)
{
  last_shown_ = Clock::now();
  last_time_ = picture.base.time;
  if (markers_.getNumSubscribers() > 0)
    showMarkers(picture, frame_id);
  if (cloud_.getNumSubscribers() > 0 && picture.particles)
    cloud_.publish(inFrame(frame_id, particleCloud(*picture.particles, picture.scene.species)));
}

void Display::showMarkers(const Picture& picture, const std::string& frame_id)
{
  MarkerArray all = pictureMarkers(picture);
  Names names;
  for (Marker& marker : all.markers)
  {
    marker.header.frame_id = frame_id;
    names.emplace(marker.ns, marker.id);
  }
  // Another scene: markers of the previous one are deleted.
  if (names != last_names_)
    all.markers.insert(all.markers.begin(), deleteAll());
  last_names_ = std::move(names);
  markers_.publish(all);
}

}  // namespace ratchet_sieve
