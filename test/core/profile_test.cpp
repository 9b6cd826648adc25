// Bases of any outline: against brute force and the sawtooth; see also contact_search_test.cpp,
// reference_test.cpp.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "flights.h"
#include "model/base_shape.h"
#include "profiles.h"
#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"
#include "search/base_overlap.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

BaseDefinition baseOf(const std::vector<OutlineCorner>& profile)
{
  BaseDefinition base;
  base.teeth = 5;
  base.profile = profile;
  return base;
}

TEST(BaseShape, NormalsPointOutOfTheBase)
{
  const BaseShape shape(BaseDefinition(), Boundary::PERIODIC);
  // a w = 6 mm, h = 6 mm: the left slope rises at 45 degrees.
  EXPECT_NEAR(shape.faces()[0].normal.x(), -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(shape.faces()[0].normal.y(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(shape.faces()[1].normal.x(), 6.0 / std::hypot(6.0, 14.0), 1e-15);
  EXPECT_NEAR(shape.faces()[1].normal.y(), 14.0 / std::hypot(6.0, 14.0), 1e-15);
  // The ratio of the slopes' lengths, which the paper compares with the ratio of contacts.
  EXPECT_NEAR(shape.faces()[0].length / shape.faces()[1].length, 0.557, 5e-4);
}

TEST(BaseShape, OnlyAPeriodicBaseGoesOnBeyondItsEnds)
{
  const BaseShape periodic(BaseDefinition(), Boundary::PERIODIC);
  const BaseShape open(BaseDefinition(), Boundary::OPEN);
  EXPECT_TRUE(periodic.hasTooth(-1));
  EXPECT_EQ(periodic.toothAt(-0.001), -1);
  EXPECT_FALSE(open.hasTooth(-1));
  EXPECT_FALSE(open.hasTooth(20));
  EXPECT_EQ(open.toothAt(0.5), 19);
}

/// Distance to the outline of all teeth within reach, and whether the point is below it, corner by corner.
double slowHeightAbove(BaseDefinition base, double s, double n)
{
  if (base.profile.empty())
    base.profile = test::asProfile(base);
  double nearest = 1e9;
  int crossings = 0;
  for (int tooth = -10; tooth < 15; ++tooth)
    for (std::size_t i = 0; i + 1 < base.profile.size(); ++i)
    {
      const Eigen::Vector2d from(base.profile[i].s + tooth * base.toothWidth(), base.profile[i].n);
      const Eigen::Vector2d to(base.profile[i + 1].s + tooth * base.toothWidth(), base.profile[i + 1].n);
      const Eigen::Vector2d way = to - from;
      const Eigen::Vector2d point(s, n);
      const double share = std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (point - from - share * way).norm());
      if (from.x() <= s && s < to.x())
        crossings += n < from.y() + (s - from.x()) / way.x() * way.y() ? 1 : 0;
    }
  return crossings % 2 == 1 ? -nearest : nearest;
}

TEST(Profile, HeightAboveIsTheDistanceToTheOutline)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const BaseDefinition base = test::drawnBase(30);
        const BaseShape shape(base, Boundary::PERIODIC);
        const double s = drawn(0.0, 0.1);
        const double n = drawn(-0.015, 0.03);
        const double slow = slowHeightAbove(base, s, n);
        RC_PRE(std::abs(slow) > 1e-9);
        RC_ASSERT(std::abs(shape.heightAbove(s, n) - slow) < 1e-12);
      }));
}

TEST(Profile, OverlapMissesNoDiskAndTheWayOutIsFree)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const BaseDefinition base = test::drawnBase(12);
        const BaseShape shape(base, Boundary::PERIODIC);
        const BaseOverlap overlap(shape);
        const double s = drawn(0.0, 0.1);
        const double n = drawn(-0.015, 0.03);
        const double radius = *rc::gen::element(1e-4, 0.001, 0.005, 0.02);
        const double height = shape.heightAbove(s, n);
        if (height < radius - 1e-12)
          RC_ASSERT(overlap.overlaps(s, n, radius));
        if (n > shape.height() + radius)
          RC_ASSERT(!overlap.overlaps(s, n, radius));
        const auto way = overlap.wayOut(s, n, radius);
        if (height > 1e-12)
          RC_ASSERT(!way);
        if (height < -1e-12)
        {
          RC_ASSERT(way.has_value());
          RC_ASSERT(shape.heightAbove(s, n + *way) > 0.0);
        }
      }));
}

TEST(Profile, NamesItsFacesBySlopeAndItsConvexCorners)
{
  const BaseDefinition base = baseOf(test::castle());
  const BaseShape shape(base, Boundary::PERIODIC);
  using Kind = CollisionKind;
  const Kind kinds[] = {Kind::LEFT_SLOPE,  Kind::RIGHT_SLOPE, Kind::LEVEL,       Kind::LEFT_SLOPE,
                        Kind::LEVEL,       Kind::LEFT_SLOPE,  Kind::RIGHT_SLOPE, Kind::LEVEL,
                        Kind::RIGHT_SLOPE, Kind::LEFT_SLOPE};
  ASSERT_EQ(shape.faces().size(), std::size(kinds));
  for (std::size_t i = 0; i < std::size(kinds); ++i)
    EXPECT_EQ(shape.faces()[i].kind, kinds[i]) << i;
  const std::int32_t convex[] = {1, 4, 6, 8};
  ASSERT_EQ(shape.corners().size(), std::size(convex));
  for (std::size_t i = 0; i < std::size(convex); ++i)
    EXPECT_EQ(shape.corners()[i].number, convex[i]);
  EXPECT_EQ(shape.height(), 0.008);
  EXPECT_EQ(shape.depth(), 0.003);
}

TEST(Profile, OfTwoSlopesHasARatioOfThem)
{
  BaseDefinition base;
  base.profile = {{0.0, 0.0}, {0.006, 0.006}, {0.02, 0.0}};
  EXPECT_NEAR(*base.slopeAsymmetry(), 0.3, 1e-15);
  base.profile[1].n = -0.006;
  EXPECT_NEAR(*base.slopeAsymmetry(), 0.7, 1e-15);
  base.profile[1].n = 0.0;
  EXPECT_FALSE(base.slopeAsymmetry());
  base.profile = test::castle();
  EXPECT_FALSE(base.slopeAsymmetry());
  base.profile.clear();
  EXPECT_NEAR(*base.slopeAsymmetry(), 0.3, 1e-15);
  base.tooth_height = 0.0;
  EXPECT_FALSE(base.slopeAsymmetry());
}

TEST(Profile, OfAFlatSawtoothIsLevel)
{
  for (SceneDefinition scene : {test::mixture(20), test::singleParticles(20)})
    for (const double asymmetry : {0.0, 0.3, 1.0})
    {
      scene.base.teeth = 5;
      scene.base.tooth_height = 0.0;
      scene.base.asymmetry = asymmetry;
      Simulation simulation(scene);
      simulation.advanceTo(1.0);
      const CollisionCounts& counts = simulation.collisions();
      EXPECT_GT(counts.level, 100u);
      EXPECT_EQ(counts.level + counts.disk_disk, counts.total());
    }
}

/// The same bits: in all loops, for all boundaries, while the base turns.
TEST(Profile, OfASawtoothIsTheSawtooth)
{
  std::vector<SceneDefinition> scenes = {test::mixture(40), test::openMixture(15), test::singleParticles(20),
                                         test::onAnOrbit(test::mixture(20)), test::mixture(30)};
  scenes[3].boundary = Boundary::WALLED;
  scenes[4].accuracy.method = Method::STEPS;
  scenes[4].accuracy.step = 0.0013;
  for (SceneDefinition& scene : scenes)
  {
    scene.base.teeth = 5;
    const SceneDefinition profile = test::onProfile(scene, test::asProfile(scene.base));
    EXPECT_FALSE(planOf(profile).simd);
    if (planOf(scene).simd)
      scene.contact.contact_duration = 1e-300;  // without SIMD
    Simulation sawtooth(scene);
    Simulation same(profile);
    for (Simulation* simulation : {&sawtooth, &same})
    {
      simulation->advanceTo(1.0);
      simulation->command(Quantity::INCLINATION, 0.1);
      simulation->advanceTo(2.0);
    }
    EXPECT_GT(same.collisions().total(), 500u);
    EXPECT_EQ(test::stateHash(same), test::stateHash(sawtooth));
    EXPECT_EQ(same.collisions().left_slope, sawtooth.collisions().left_slope);
    EXPECT_EQ(same.faceContacts().face_contacts[0], same.collisions().left_slope);
    EXPECT_EQ(same.faceContacts().face_contacts[1], same.collisions().right_slope);
    EXPECT_EQ(same.faceContacts().corner_contacts[1] + same.faceContacts().corner_contacts[0],
              same.collisions().apex);
    EXPECT_TRUE(sawtooth.faceContacts().face_contacts.empty());
  }
}

/// Thousands of tiny faces, a spike of needle thinness, steps of a nanometre.
TEST(Profile, MayHaveManyAndTinyFaces)
{
  std::vector<OutlineCorner> rough = {{0.0, 0.0}};
  for (int i = 1; i < 5000; ++i)
    rough.push_back({4e-6 * i, 2e-6 * (i % 2)});
  rough.push_back({0.02, 0.0});
  const std::vector<OutlineCorner> spike = {{0.0, 0.0},          {0.009, 0.0}, {0.01, 0.03},
                                            {0.010000001, 0.0},  {0.015, 0.0}, {0.015, 1e-9},
                                            {0.02 - 1e-9, 1e-9}, {0.02, 0.0}};
  for (const auto& profile : {rough, spike, test::arc(0.02, 0.006, 1000), test::arc(0.02, -0.006, 1000)})
    for (const bool steps : {false, true})
    {
      SceneDefinition scene = test::onProfile(test::mixture(15), profile);
      scene.base.teeth = 3;
      scene.boundary = Boundary::WALLED;
      scene.accuracy.method = steps ? Method::STEPS : Method::EVENTS;
      Simulation simulation(scene);
      simulation.advanceTo(0.7);
      EXPECT_GT(simulation.collisions().total(), 100u);
      test::expectNoOverlap(simulation, steps ? 1.0 : 1e-12);
    }
}

}  // namespace
}  // namespace ratchet_sieve
