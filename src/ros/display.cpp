#include "display.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include "scene_markers.h"

namespace ratchet_sieve
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::uint32_t PICTURE_QUEUE_SIZE = 2;
constexpr double STILL_PERIOD = 1.0;  // between pictures of a paused run [s]
}  // namespace

sensor_msgs::PointCloud2 particleCloud(const ParticleFrame& frame,
                                       const std::vector<SpeciesDefinition>& species,
                                       const std::string& frame_id)
{
  using Field = sensor_msgs::PointField;
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(frame.time);
  cloud.header.frame_id = frame_id;
  cloud.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(5, "x", 1, Field::FLOAT32, "y", 1, Field::FLOAT32, "z", 1, Field::FLOAT32,
                                "radius", 1, Field::FLOAT32, "species", 1, Field::UINT32);
  modifier.resize(frame.disks.size());
  if (frame.disks.empty())
    return cloud;  // its iterators refer to a first byte
  sensor_msgs::PointCloud2Iterator<float> position(cloud, "x");
  sensor_msgs::PointCloud2Iterator<float> radius(cloud, "radius");
  sensor_msgs::PointCloud2Iterator<std::uint32_t> kind(cloud, "species");
  for (const DiskState& disk : frame.disks)
  {
    position[0] = static_cast<float>(disk.x);
    position[1] = 0.0f;
    position[2] = static_cast<float>(disk.y);
    *radius = static_cast<float>(radiusOf(disk, species));
    *kind = disk.species;
    ++position, ++radius, ++kind;
  }
  return cloud;
}

Display::Display(ros::NodeHandle private_node, double rate)
    : rate_(rate),
      markers_(private_node.advertise<MarkerArray>("markers", PICTURE_QUEUE_SIZE)),
      cloud_(private_node.advertise<sensor_msgs::PointCloud2>("cloud", PICTURE_QUEUE_SIZE))
{
}

bool Display::due(double time) const
{
  const double waited = std::chrono::duration<double>(Clock::now() - last_shown_).count();
  const bool watched = markers_.getNumSubscribers() > 0 || cloud_.getNumSubscribers() > 0;
  return watched && rate_ > 0.0 && waited >= (time == last_time_ ? STILL_PERIOD : 1.0 / rate_);
}

void Display::show(const Picture& picture, const std::string& frame_id)
{
  last_shown_ = Clock::now();
  last_time_ = picture.base.time;
  if (markers_.getNumSubscribers() > 0)
    showMarkers(picture, frame_id);
  if (cloud_.getNumSubscribers() > 0 && picture.particles)
    cloud_.publish(particleCloud(*picture.particles, picture.scene.species, frame_id));
}

void Display::showMarkers(const Picture& picture, const std::string& frame_id)
{
  MarkerArray all = pictureMarkers(picture);
  std::set<std::pair<std::string, int>> names;
  for (Marker& marker : all.markers)
  {
    marker.header.frame_id = frame_id;
    names.emplace(marker.ns, marker.id);
  }
  if (names != last_names_)
  {
    // Another scene: markers of the previous one are deleted.
    Marker none;
    none.action = Marker::DELETEALL;
    all.markers.insert(all.markers.begin(), none);
  }
  last_names_ = std::move(names);
  markers_.publish(all);
}

}  // namespace ratchet_sieve
