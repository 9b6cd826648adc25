#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "model/base_shape.h"
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
Vector inWorld(const std::vector<geometry_msgs::TransformStamped>& transforms, const Vector& point)
{
  Vector v = point;
  for (std::size_t k = transforms.size(); k-- > 0;)
  {
    const geometry_msgs::Transform& transform = transforms[k].transform;
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
  const auto transforms = baseTransforms(inclinedBase(0.1, 0.0));
  ASSERT_EQ(transforms.size(), 2u);
  EXPECT_EQ(transforms[0].header.frame_id, "world");
  EXPECT_EQ(transforms[0].child_frame_id, "sieve_mount");
  EXPECT_EQ(transforms[1].header.frame_id, "sieve_mount");
  EXPECT_EQ(transforms[1].child_frame_id, "sieve_base");
}

TEST(BaseTransforms, raiseTheRightEndForPositiveInclination)
{
  const auto transforms = baseTransforms(inclinedBase(0.25, 0.0));
  const Vector right_end = inWorld(transforms, {0.4, 0.0, 0.0});
  EXPECT_NEAR(right_end.x, 0.4 * std::cos(0.25), 1e-15);
  EXPECT_NEAR(right_end.z, 0.4 * std::sin(0.25), 1e-15);
}

TEST(BaseTransforms, moveTheBaseByItsDriveInTheWorldWhateverItsInclination)
{
  for (const double inclination : {-0.4, 0.0, 0.3})
  {
    const Vector rest = inWorld(baseTransforms(inclinedBase(inclination, 0.0)), {0.1, 0.0, 0.006});
    const Vector up = inWorld(baseTransforms(inclinedBase(inclination, 0.002)), {0.1, 0.0, 0.006});
    EXPECT_NEAR(up.x, rest.x, 1e-15);
    EXPECT_NEAR(up.z - rest.z, 0.002, 1e-15);
    BaseFrame oblique = inclinedBase(inclination, 0.002);
    oblique.base.horizontal_displacement = -0.003;
    const Vector aside = inWorld(baseTransforms(oblique), {0.1, 0.0, 0.006});
    EXPECT_NEAR(aside.x - rest.x, -0.003, 1e-15);
    EXPECT_NEAR(aside.z - rest.z, 0.002, 1e-15);
  }
}

TEST(SceneMarkers, drawTheBaseWhereTheEngineHasIt)
{
  const SceneDefinition scene = smallMixture();
  const BaseShape shape(scene.base, scene.boundary);
  const auto markers = baseMarkers(scene, BaseFrame()).markers;
  ASSERT_EQ(markers.size(), 2u);
  EXPECT_EQ(markers[1].points.size(), 4u * scene.base.teeth);
  for (const auto& point : markers[1].points)
    EXPECT_NEAR(shape.heightAbove(point.x, point.z), 0.0, 1e-12);
}

TEST(SceneMarkers, drawEachCornerOfAProfile)
{
  SceneDefinition scene = smallMixture();
  scene.base.profile = {{0.0, 0.0}, {0.012, 0.006}, {0.012, 0.0}, {0.02, 0.0}};
  const auto points = baseMarkers(scene, BaseFrame()).markers[1].points;
  ASSERT_EQ(points.size(), 6u * scene.base.teeth);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const OutlineCorner& corner = scene.base.profile[k % 6 / 2 + k % 2];
    EXPECT_DOUBLE_EQ(points[k].x, static_cast<double>(k / 6) * scene.base.toothWidth() + corner.s);
    EXPECT_DOUBLE_EQ(points[k].z, corner.n);
  }
}

/// The highest and the furthest point of the drawn base, in its own frame.
Vector reachOfBase(const SceneDefinition& scene)
{
  Vector reach{0.0, 0.0, 0.0};
  for (const auto& point : baseMarkers(scene, BaseFrame()).markers[0].points)
    reach = {std::max(reach.x, point.x), 0.0, std::max(reach.z, point.z)};
  return reach;
}

TEST(SceneMarkers, drawWallsBesideTheBaseUpToTheirHeight)
{
  SceneDefinition scene = smallMixture();
  EXPECT_EQ(reachOfBase(scene).z, scene.base.tooth_height);
  scene.boundary = Boundary::WALLED;
  scene.base.wall_height = 0.013;
  EXPECT_NEAR(reachOfBase(scene).z, 0.013, 1e-15);
  EXPECT_GT(reachOfBase(scene).x, scene.base.width());
  // The default walls, at least ten widths high, are cut off at the edge of the view.
  scene.base.wall_height = 0.0;
  EXPECT_LT(reachOfBase(scene).z, 0.3 * scene.base.width());
  EXPECT_GT(reachOfBase(scene).z, 0.1 * scene.base.width());
}

TEST(SceneMarkers, moveTheBaseAsTheTransformsDo)
{
  const BaseFrame base = inclinedBase(0.2, 0.0017);
  for (const auto& part : baseMarkers(smallMixture(), base).markers)
  {
    EXPECT_EQ(part.header.frame_id, "world");
    const Vector turned = rotated(part.pose.orientation, {0.07, 0.0, 0.005});
    const Vector expected = inWorld(baseTransforms(base), {0.07, 0.0, 0.005});
    EXPECT_NEAR(turned.x + part.pose.position.x, expected.x, 1e-15);
    EXPECT_NEAR(turned.z + part.pose.position.z, expected.z, 1e-15);
  }
}

TEST(SceneMarkers, drawDisksOfManySizesWithinTwoPercent)
{
  SceneDefinition scene = smallMixture();
  scene.species[1].size = {SizeDistribution::LOGNORMAL, 0.5, 3.0, {}, {}, {}};
  const Sizes sizes(scene.species[1]);
  ParticleFrame frame;
  for (int k = 0; k <= 100; ++k)
  {
    const double radius = sizes.smallest() + 0.01 * k * (sizes.largest() - sizes.smallest());
    frame.disks.push_back({static_cast<std::uint32_t>(k), 1, radius, 0.02, 0, 0, 0, 0, 0, radius});
  }
  const auto color = diskMarkers(smallMixture(), ParticleFrame()).markers.at(1).color;
  std::size_t drawn = 0;
  for (const auto& list : diskMarkers(scene, frame).markers)
    for (const auto& point : list.points)
      if (list.ns == "disks")
      {
        ++drawn;
        EXPECT_NEAR(list.scale.x, 2.0 * point.x, 0.0405 * point.x);
        EXPECT_EQ(list.color, color);
      }
  EXPECT_EQ(drawn, frame.disks.size());
}

TEST(SceneMarkers, drawDisksInTrueSizeOneListPerSpecies)
{
  const SceneDefinition scene = smallMixture();
  ParticleFrame frame;
  frame.disks = {{7, 1, 0.01, 0.02, 0, 0, 0, 0, 0}, {9, 1, 0.03, 0.04, 0, 0, 0, 0, 0}};
  const auto markers = diskMarkers(scene, frame).markers;
  ASSERT_EQ(markers.size(), 4u);
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::DELETE);
  EXPECT_EQ(markers[1].type, visualization_msgs::Marker::SPHERE_LIST);
  EXPECT_EQ(markers[1].scale.x, 2.0 * scene.species[1].radius);
  ASSERT_EQ(markers[1].points.size(), 2u);
  EXPECT_EQ(markers[1].points[1].x, 0.03);
  EXPECT_EQ(markers[1].points[1].y, 0.0);
  EXPECT_EQ(markers[1].points[1].z, 0.04);
}

TEST(SceneMarkers, markEachDiskWhereItHasTurnedTo)
{
  const SceneDefinition scene = smallMixture();
  ParticleFrame frame;
  frame.disks = {{7, 1, 0.01, 0.02, 0.0, 0, 0, 0, 0}, {9, 1, 0.03, 0.04, 1.1, 0, 0, 0, 0}};
  const auto markers = diskMarkers(scene, frame).markers;
  EXPECT_EQ(markers[2].action, visualization_msgs::Marker::DELETE);
  const auto& dots = markers[3];
  ASSERT_EQ(dots.points.size(), 2u);
  EXPECT_LT(dots.scale.x, 0.5 * markers[1].scale.x);
  for (std::size_t k = 0; k < 2; ++k)
  {
    const DiskState& disk = frame.disks[k];
    const double x = dots.points[k].x - disk.x;
    const double z = dots.points[k].z - disk.y;
    EXPECT_NEAR(std::atan2(z, x), disk.angle, 1e-12);
    // On the sphere, on the viewer's side.
    EXPECT_NEAR(std::hypot(x, z, dots.points[k].y), scene.species[1].radius, 1e-15);
    EXPECT_LT(dots.points[k].y, 0.0);
  }
}

BinFrame someBins()
{
  BinFrame frame;
  frame.species = {"A", "B"};
  frame.bins = {{1, 2, 3}, {4, 5, 6}};
  return frame;
}

TEST(SceneMarkers, showBinsOfAnOpenBaseOnly)
{
  SceneDefinition scene = smallMixture();
  EXPECT_FALSE(binMarkers(scene, someBins(), BaseFrame()).markers.empty());
  scene.boundary = Boundary::PERIODIC;
  EXPECT_TRUE(binMarkers(scene, someBins(), BaseFrame()).markers.empty());
}

TEST(SceneMarkers, sayUndefinedWhereQualityIsNot)
{
  const SceneDefinition scene = smallMixture();
  Picture picture{scene, BaseFrame(), someBins(), {}, {}};
  picture.bins->processed = 0.5;
  const auto markers = captionMarkers(picture).markers;
  ASSERT_EQ(markers.size(), 4u);
  EXPECT_EQ(markers[1].text, "Q = undefined    P = 0.500");
}

TEST(SceneMarkers, sayWhereTheBaseIsAndWhereItIsGoing)
{
  const SceneDefinition scene = smallMixture();
  Picture picture{scene, inclinedBase(0.1, 0.0), {}, {}, {}};
  DriveState& base = picture.base.base;
  base.commanded_inclination = 0.19;
  base.frequency = base.commanded_frequency = 23.0;
  const std::string words = captionMarkers(picture).markers.at(0).text;
  EXPECT_NE(words.find("theta = +0.100 -> +0.190 rad"), std::string::npos) << words;
  EXPECT_NE(words.find("f = 23.0 Hz"), std::string::npos) << words;
}

TEST(SceneMarkers, nameEachSpeciesInItsColour)
{
  const SceneDefinition scene = smallMixture();
  const auto markers = captionMarkers({scene, BaseFrame(), someBins(), {}, {}}).markers;
  ASSERT_EQ(markers.size(), 4u);
  EXPECT_EQ(markers[2].text, "A: r = 1 mm, m = 10 g, 3 on the base");
  EXPECT_EQ(markers[3].text, "B: r = 3 mm, m = 1 g, 6 on the base");
  EXPECT_EQ(markers[3].color, diskMarkers(scene, ParticleFrame()).markers.at(1).color);
}

TEST(SceneMarkers, keepTextsOffBinsAndDisks)
{
  SceneDefinition scene = smallMixture();
  const double over_few_teeth = captionHeight(scene, 0.0);
  scene.base.teeth = 40;
  EXPECT_GT(over_few_teeth, captionHeight(scene, 0.0));
  scene.species[0].size.spread = 0.5;
  const Picture picture{scene, BaseFrame(), someBins(), {}, {}};
  const auto legendWidth = [&]
  {
    const auto line = captionMarkers(picture).markers.at(2);
    return 0.55 * static_cast<double>(line.text.size()) * line.scale.z / scene.base.width();
  };
  EXPECT_EQ(captionMarkers(picture).markers.at(2).text, "A: r = 0.5 to 1.5 mm, 3 on the base");
  EXPECT_LT(legendWidth(), 1.0);
  scene.species[0].name = std::string(100, 'A');
  EXPECT_LT(legendWidth(), 1.0);
}

TEST(SceneMarkers, sayTheMeanVelocityOfEachSpeciesWithItsError)
{
  const SceneDefinition scene = smallMixture();
  Picture picture{scene, BaseFrame(), {}, {}, std::vector<SpeciesMeans>(2)};
  picture.means[0].mean_vx = 0.01234;
  picture.means[0].mean_vx_stderr = 0.00056;
  const auto markers = captionMarkers(picture).markers;
  ASSERT_EQ(markers.size(), 3u);
  EXPECT_EQ(markers[1].text, "A: r = 1 mm, m = 10 g, <V_x> = +12.3 +- 0.6 mm/s");
  EXPECT_EQ(markers[2].text, "B: r = 3 mm, m = 1 g, <V_x> = undefined");
}

TEST(SceneMarkers, leaveOutWhatNobodyRecorded)
{
  const SceneDefinition scene = smallMixture();
  std::set<std::string> names;
  for (const auto& marker : pictureMarkers({scene, BaseFrame(), {}, {}, {}}).markers)
    names.insert(marker.ns);
  EXPECT_EQ(names, (std::set<std::string>{"base", "caption", "legend"}));
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
