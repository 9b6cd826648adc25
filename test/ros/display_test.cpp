#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_eigen/tf2_eigen.h>

#include "display.h"
#include "model/base_shape.h"
#include "scene_markers.h"
#include "small_scenes.h"
#include "transform_publisher.h"

namespace ratchet_sieve
{
namespace
{
/// A point of sieve_base in the world.
Eigen::Vector3d inWorld(const std::vector<geometry_msgs::TransformStamped>& transforms,
                        const Eigen::Vector3d& point)
{
  return tf2::transformToEigen(transforms.at(0)) * (tf2::transformToEigen(transforms.at(1)) * point);
}

BaseFrame inclinedBase(double inclination, double displacement)
{
  BaseFrame frame;
  frame.base.inclination = inclination;
  frame.base.displacement = displacement;
  return frame;
}

TEST(FrameNames, haveTheNameOfEverySieveButTheUsualOne)
{
  EXPECT_EQ(defaultFramePrefix("/sieve"), "");
  EXPECT_EQ(defaultFramePrefix("/s1"), "s1");
  EXPECT_EQ(defaultFramePrefix("/plant1/sieve"), "plant1/sieve");
  EXPECT_EQ(defaultFramePrefix("/"), "");
}

TEST(FrameNames, refuseAPrefixThatNoFrameCanHave)
{
  for (const char* good : {"", "s1", "plant1/sieve", "S_2"})
    EXPECT_EQ(framePrefixError(good), "") << good;
  for (const char* bad : {"/s1", "s1/", "1s", "~s1", "s 1", "s-1"})
    EXPECT_NE(framePrefixError(bad), "") << bad;
}

TEST(BaseTransforms, leadFromWorldOverMountToBase)
{
  const auto links = [](const FrameNames& names)
  {
    std::string text;
    for (const auto& link : baseTransforms(BaseFrame(), names))
      text += link.header.frame_id + " -> " + link.child_frame_id + " ";
    return text;
  };
  EXPECT_EQ(links(frameNames("", false)), "world -> sieve_mount sieve_mount -> sieve_base ");
  const FrameNames own = frameNames("plant1/s1", true);
  EXPECT_EQ(links(own),
            "plant1/s1/sieve_world -> plant1/s1/sieve_mount "
            "plant1/s1/sieve_mount -> plant1/s1/sieve_base ");
  const auto world = ownWorldTransform({1.0, 2.0, -3.0}, own);
  EXPECT_EQ(world.header.frame_id, "world");
  EXPECT_EQ(world.child_frame_id, own.world);
  EXPECT_EQ(tf2::transformToEigen(world).translation(), Eigen::Vector3d(1.0, 2.0, -3.0));
}

TEST(BaseTransforms, raiseTheRightEndForPositiveInclination)
{
  const Eigen::Vector3d right_end = inWorld(baseTransforms(inclinedBase(0.25, 0.0)), {0.4, 0.0, 0.0});
  EXPECT_TRUE(right_end.isApprox(Eigen::Vector3d(0.4 * std::cos(0.25), 0.0, 0.4 * std::sin(0.25)), 1e-14));
}

TEST(BaseTransforms, moveTheBaseByItsDriveInTheWorldWhateverItsInclination)
{
  for (const double inclination : {-0.4, 0.0, 0.3})
  {
    const Eigen::Vector3d point(0.1, 0.0, 0.006);
    BaseFrame moved = inclinedBase(inclination, 0.002);
    moved.base.horizontal_displacement = -0.003;
    const Eigen::Vector3d by = inWorld(baseTransforms(moved), point) -
                               inWorld(baseTransforms(inclinedBase(inclination, 0.0)), point);
    EXPECT_LT((by - Eigen::Vector3d(-0.003, 0.0, 0.002)).norm(), 1e-15);
  }
}

TEST(SceneMarkers, drawTheBaseWhereTheEngineHasIt)
{
  SceneDefinition scene = smallMixture();
  for (const std::size_t faces : {2u, 3u})
  {
    if (faces == 3)
      scene.base.profile = {{0.0, 0.0}, {0.012, 0.006}, {0.012, 0.0}, {0.02, 0.0}};
    const BaseShape shape(scene.base, scene.boundary);
    const auto markers = baseMarkers(scene, BaseFrame()).markers;
    ASSERT_EQ(markers.size(), 2u);
    EXPECT_EQ(markers[1].points.size(), 2 * faces * scene.base.teeth);
    for (const auto& point : markers[1].points)
      EXPECT_NEAR(shape.heightAbove(point.x, point.z), 0.0, 1e-12);
  }
}

/// The highest and the furthest point of the drawn base, in its own frame.
Eigen::Vector3d reachOfBase(const SceneDefinition& scene)
{
  Eigen::Vector3d reach = Eigen::Vector3d::Zero();
  const auto drawn = baseMarkers(scene, BaseFrame());
  for (const auto& point : drawn.markers[0].points)
    reach = reach.cwiseMax(Eigen::Vector3d(point.x, point.y, point.z));
  return reach;
}

TEST(SceneMarkers, drawWallsBesideTheBaseUpToTheirHeight)
{
  SceneDefinition scene = smallMixture();
  EXPECT_EQ(reachOfBase(scene).z(), scene.base.tooth_height);
  scene.boundary = Boundary::WALLED;
  scene.base.wall_height = 0.013;
  EXPECT_NEAR(reachOfBase(scene).z(), 0.013, 1e-15);
  EXPECT_GT(reachOfBase(scene).x(), scene.base.width());
  // The default walls, at least ten widths high, are cut off at the edge of the view.
  scene.base.wall_height = 0.0;
  EXPECT_LT(reachOfBase(scene).z(), 0.3 * scene.base.width());
  EXPECT_GT(reachOfBase(scene).z(), 0.1 * scene.base.width());
}

TEST(SceneMarkers, moveTheBaseAsTheTransformsDo)
{
  const BaseFrame base = inclinedBase(0.2, 0.0017);
  for (const auto& part : baseMarkers(smallMixture(), base).markers)
  {
    EXPECT_EQ(part.header.frame_id, "world");
    Eigen::Isometry3d pose;
    tf2::fromMsg(part.pose, pose);
    const Eigen::Vector3d point(0.07, 0.0, 0.005);
    EXPECT_LT((pose * point - inWorld(baseTransforms(base), point)).norm(), 1e-15);
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

TEST(SceneMarkers, drawDisksInTrueSizeAndWhereEachHasTurnedTo)
{
  const SceneDefinition scene = smallMixture();
  ParticleFrame frame;
  frame.disks = {{7, 1, 0.01, 0.02, 0.0, 0, 0, 0, 0}, {9, 1, 0.03, 0.04, 1.1, 0, 0, 0, 0}};
  const auto markers = diskMarkers(scene, frame).markers;
  ASSERT_EQ(markers.size(), 4u);
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::DELETE);
  EXPECT_EQ(markers[2].action, visualization_msgs::Marker::DELETE);
  const auto &disks = markers[1], &dots = markers[3];
  EXPECT_EQ(disks.type, visualization_msgs::Marker::SPHERE_LIST);
  EXPECT_EQ(disks.scale.x, 2.0 * scene.species[1].radius);
  ASSERT_EQ(disks.points.size(), 2u);
  ASSERT_EQ(dots.points.size(), 2u);
  EXPECT_LT(dots.scale.x, 0.5 * disks.scale.x);
  for (std::size_t k = 0; k < 2; ++k)
  {
    const DiskState& disk = frame.disks[k];
    EXPECT_EQ(disks.points[k].x, disk.x);
    EXPECT_EQ(disks.points[k].y, 0.0);
    EXPECT_EQ(disks.points[k].z, disk.y);
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

TEST(SceneMarkers, sayHowTheRunIs)
{
  const SceneDefinition scene = smallMixture();
  Picture picture{scene, inclinedBase(0.1, 0.0), someBins(), {}, std::vector<SpeciesMeans>(2)};
  DriveState& base = picture.base.base;
  base.commanded_inclination = 0.19;
  base.frequency = base.commanded_frequency = 23.0;
  picture.bins->processed = 0.5;
  picture.means[0].mean_vx = 0.01234;
  picture.means[0].mean_vx_stderr = 0.00056;
  std::vector<std::string> words;
  for (const auto& marker : captionMarkers(picture).markers)
    words.push_back(marker.text);
  EXPECT_EQ(words, (std::vector<std::string>{
                       "t = 0.00 s    theta = +0.100 -> +0.190 rad    f = 23.0 Hz    A = 0.00 mm",
                       "Q = undefined    P = 0.500",
                       "A: r = 1 mm, m = 10 g, 3 on the base, <V_x> = +12.3 +- 0.6 mm/s",
                       "B: r = 3 mm, m = 1 g, 6 on the base, <V_x> = undefined"}));
  picture.sieve = "line2/sieve";
  EXPECT_EQ(captionMarkers(picture).markers[1].text, "line2/sieve    Q = undefined    P = 0.500");
  picture.bins.reset();
  EXPECT_EQ(captionMarkers(picture).markers[1].text, "line2/sieve");
  EXPECT_EQ(captionMarkers(picture).markers[3].color,
            diskMarkers(scene, ParticleFrame()).markers.at(1).color);
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
  const auto cloud = particleCloud(frame, scene.species, "s1/sieve_world");
  EXPECT_EQ(cloud.width, 2u);
  EXPECT_EQ(cloud.header.frame_id, "s1/sieve_world");
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
