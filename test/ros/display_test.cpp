#include <cmath>

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "ratchet_sieve/core/sawtooth.h"
#include "ratchet_sieve/ros/particle_cloud.h"
#include "ratchet_sieve/ros/scene_markers.h"
#include "ratchet_sieve/ros/transform_publisher.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
struct Vector
{
  double x, y, z;
};

/// q v q*, for a rotation about y.
Vector rotated(const geometry_msgs::Quaternion& q, const Vector& v)
{
  EXPECT_EQ(q.x, 0.0);
  EXPECT_EQ(q.z, 0.0);
  const double cosine = q.w * q.w - q.y * q.y;
  const double sine = 2.0 * q.w * q.y;
  return {cosine * v.x + sine * v.z, v.y, -sine * v.x + cosine * v.z};
}

/// A point of sieve_base in the world.
Vector inWorld(const tf2_msgs::TFMessage& message, const Vector& point)
{
  Vector v = point;
  for (std::size_t k = message.transforms.size(); k-- > 0;)
  {
    const geometry_msgs::Transform& transform = message.transforms[k].transform;
    v = rotated(transform.rotation, v);
    v = {v.x + transform.translation.x, v.y + transform.translation.y, v.z + transform.translation.z};
  }
  return v;
}

BaseFrame inclinedBase(double inclination, double displacement)
{
  BaseFrame frame;
  frame.base.inclination = inclination;
  frame.base.displacement = displacement;
  return frame;
}

TEST(BaseTransforms, leadFromWorldOverMountToBase)
{
  const auto message = baseTransforms(inclinedBase(0.1, 0.0));
  ASSERT_EQ(message.transforms.size(), 2u);
  EXPECT_EQ(message.transforms[0].header.frame_id, "world");
  EXPECT_EQ(message.transforms[0].child_frame_id, "sieve_mount");
  EXPECT_EQ(message.transforms[1].header.frame_id, "sieve_mount");
  EXPECT_EQ(message.transforms[1].child_frame_id, "sieve_base");
}

TEST(BaseTransforms, raiseTheRightEndForPositiveInclination)
{
  const auto message = baseTransforms(inclinedBase(0.25, 0.0));
  const Vector right_end = inWorld(message, {0.4, 0.0, 0.0});
  EXPECT_NEAR(right_end.x, 0.4 * std::cos(0.25), 1e-15);
  EXPECT_NEAR(right_end.z, 0.4 * std::sin(0.25), 1e-15);
}

TEST(BaseTransforms, moveTheBaseVerticallyInTheWorldWhateverItsInclination)
{
  for (const double inclination : {-0.4, 0.0, 0.3})
  {
    const Vector rest = inWorld(baseTransforms(inclinedBase(inclination, 0.0)), {0.1, 0.0, 0.006});
    const Vector up = inWorld(baseTransforms(inclinedBase(inclination, 0.002)), {0.1, 0.0, 0.006});
    EXPECT_NEAR(up.x, rest.x, 1e-15);
    EXPECT_NEAR(up.z - rest.z, 0.002, 1e-15);
  }
}

TEST(SceneMarkers, drawTheBaseWhereTheEngineHasIt)
{
  const SceneDefinition scene = smallMixture();
  const Sawtooth sawtooth(scene.base, scene.boundary);
  const auto markers = baseMarkers(scene, 0.0).markers;
  ASSERT_EQ(markers.size(), 2u);
  EXPECT_EQ(markers[1].header.frame_id, "sieve_base");
  EXPECT_EQ(markers[1].points.size(), 4u * scene.base.teeth);
  for (const auto& point : markers[1].points)
    EXPECT_NEAR(sawtooth.heightAbove(point.x, point.z), 0.0, 1e-12);
}

TEST(SceneMarkers, drawDisksInTrueSizeOneListPerSpecies)
{
  const SceneDefinition scene = smallMixture();
  ParticleFrame frame;
  frame.disks = {{7, 1, 0.01, 0.02, 0, 0, 0, 0, 0}, {9, 1, 0.03, 0.04, 0, 0, 0, 0, 0}};
  const auto markers = diskMarkers(scene, frame).markers;
  ASSERT_EQ(markers.size(), 2u);
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::DELETE);
  EXPECT_EQ(markers[1].type, visualization_msgs::Marker::SPHERE_LIST);
  EXPECT_EQ(markers[1].scale.x, 2.0 * scene.species[1].radius);
  ASSERT_EQ(markers[1].points.size(), 2u);
  EXPECT_EQ(markers[1].points[1].x, 0.03);
  EXPECT_EQ(markers[1].points[1].y, 0.0);
  EXPECT_EQ(markers[1].points[1].z, 0.04);
}

TEST(SceneMarkers, showBinsOfAnOpenBaseOnly)
{
  SceneDefinition scene = smallMixture();
  BinFrame frame;
  frame.species = {"A", "B"};
  frame.bins = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_FALSE(binMarkers(scene, frame, DriveState()).markers.empty());
  scene.boundary = Boundary::PERIODIC;
  EXPECT_TRUE(binMarkers(scene, frame, DriveState()).markers.empty());
}

TEST(SceneMarkers, sayUndefinedWhereQualityIsNot)
{
  BinFrame frame;
  frame.processed = 0.5;
  const auto markers = captionMarkers(smallMixture(), frame, DriveState()).markers;
  ASSERT_EQ(markers.size(), 1u);
  EXPECT_NE(markers[0].text.find("Q = undefined"), std::string::npos) << markers[0].text;
  EXPECT_NE(markers[0].text.find("P = 0.500"), std::string::npos) << markers[0].text;
}

TEST(ParticleCloud, carriesPlaceRadiusAndSpecies)
{
  const SceneDefinition scene = smallMixture();
  ParticleFrame frame;
  frame.disks = {{0, 0, 0.25, 0.5, 0, 0, 0, 0, 0}, {1, 1, 0.75, 1.0, 0, 0, 0, 0, 0}};
  const auto cloud = particleCloud(frame, scene.species);
  EXPECT_EQ(cloud.width, 2u);
  EXPECT_EQ(cloud.header.frame_id, "world");
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x"), z(cloud, "z"), radius(cloud, "radius");
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> species(cloud, "species");
  ++x, ++z, ++radius, ++species;
  EXPECT_EQ(*x, 0.75f);
  EXPECT_EQ(*z, 1.0f);
  EXPECT_EQ(*radius, static_cast<float>(scene.species[1].radius));
  EXPECT_EQ(*species, 1u);
}
}  // namespace
}  // namespace ratchet_sieve
