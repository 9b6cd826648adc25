#include "ratchet_sieve/ros/particle_cloud.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{

sensor_msgs::PointCloud2 particleCloud(const ParticleFrame& frame,
                                       const std::vector<SpeciesDefinition>& species)
{
  using Field = sensor_msgs::PointField;
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = stampOf(frame.time);
  cloud.header.frame_id = WORLD_FRAME_ID;
  cloud.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(5, "x", 1, Field::FLOAT32, "y", 1, Field::FLOAT32, "z", 1, Field::FLOAT32,
                                "radius", 1, Field::FLOAT32, "species", 1, Field::UINT32);
  modifier.resize(frame.disks.size());
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
    ++position;
    ++radius;
    ++kind;
  }
  return cloud;
}

}  // namespace ratchet_sieve
