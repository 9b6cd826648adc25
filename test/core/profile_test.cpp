// Bases of any outline: the engine against brute force, the slow reference loop, conservation and the
// sawtooth.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "flights.h"
#include "model/base_shape.h"
#include "profiles.h"
#include "ratchet_sieve/core/simulation.h"
#include "reference_loop.h"
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

/// Where two teeth meet is a corner as any other.
TEST(Profile, HasACornerBetweenGrooves)
{
  const BaseShape shape(baseOf({{0.0, 0.0}, {0.01, -0.005}, {0.02, 0.0}}), Boundary::PERIODIC);
  ASSERT_EQ(shape.corners().size(), 1u);
  EXPECT_EQ(shape.corners()[0].number, 0);
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
    Plan plan = planOf(scene);
    plan.simd = false;
    Simulation sawtooth(scene, plan);
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

/// A face in many pieces is the face, but for the rounding of its pieces.
TEST(Profile, CutIntoPiecesFliesTheSameFirstContacts)
{
  SceneDefinition whole = test::singleParticles(30);
  whole.base.teeth = 5;
  whole.base.profile = test::asProfile(whole.base);
  SceneDefinition pieces = whole;
  pieces.base.profile.clear();
  for (int i = 0; i < 50; ++i)
    pieces.base.profile.push_back({0.006 * i / 50, 0.006 * i / 50});
  for (int i = 0; i <= 70; ++i)
    pieces.base.profile.push_back({0.006 + 0.014 * i / 70, 0.006 - 0.006 * i / 70});
  pieces.base.profile.back() = {0.02, 0.0};
  Simulation one(whole);
  Simulation many(pieces);
  one.advanceTo(0.15);
  many.advanceTo(0.15);
  EXPECT_GT(one.collisions().total(), 30u);
  EXPECT_EQ(one.collisions().total(), many.collisions().total());
  for (std::size_t i = 0; i < one.disks().size(); ++i)
  {
    EXPECT_NEAR(one.disks()[i].x, many.disks()[i].x, 1e-9);
    EXPECT_NEAR(one.disks()[i].vy, many.disks()[i].vy, 1e-7);
  }
  const FaceContacts& contacts = many.faceContacts();
  EXPECT_EQ(std::accumulate(contacts.face_contacts.begin(), contacts.face_contacts.begin() + 50, 0ull),
            many.collisions().left_slope);
}

SceneDefinition drawnLayer()
{
  SceneDefinition scene = test::mixture(*rc::gen::inRange(1, 8));
  scene.base.teeth = *rc::gen::inRange(1, 4);
  scene.base.profile = test::drawnProfile(0.02, *rc::gen::element(0.002, 0.01, 0.03), 10);
  scene.base.inclination = *rc::gen::element(0.0, 0.2, -0.2);
  scene.boundary = *rc::gen::element(Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED);
  scene.species[0].radius = *rc::gen::element(2e-4, 0.001, 0.003);
  scene.seed = *rc::gen::arbitrary<std::uint64_t>();
  return scene;
}

std::vector<CollisionRecord> profileCollisions(const SceneDefinition& scene, double end, bool reference)
{
  std::vector<CollisionRecord> records;
  const auto observe = [&](const CollisionRecord& record)
  {
    // A disk that is jammed between two faces has contacts without end.
    RC_PRE(records.size() < 2000u);
    records.push_back(record);
  };
  if (reference)
  {
    test::runReference(scene, end, observe);
    return records;
  }
  Simulation simulation(scene);
  simulation.observeCollisions(observe);
  simulation.advanceTo(end);
  return records;
}

/// The contacts of a disk that follow from fewer than so many others, one after another: in those, rounding
/// has not grown.
struct EarlyContacts
{
  std::vector<CollisionRecord> records;
  double later = std::numeric_limits<double>::infinity();  ///< of the first that follows from more [s]
};

std::vector<EarlyContacts> earlyContacts(const std::vector<CollisionRecord>& all, std::size_t disks,
                                         int deepest)
{
  std::vector<EarlyContacts> early(disks);
  std::vector<int> depth(disks, 0);
  for (const CollisionRecord& record : all)
  {
    const std::uint32_t partner = record.j.value_or(record.i);
    depth[record.i] = depth[partner] = 1 + std::max(depth[record.i], depth[partner]);
    for (const std::uint32_t disk : std::set<std::uint32_t>{record.i, partner})
      if (depth[disk] <= deepest)
        early[disk].records.push_back(record);
      else
        early[disk].later = std::min(early[disk].later, record.time);
  }
  return early;
}

/// The same contacts, up to the first that rounding may have moved. @return how many
std::size_t checkSame(const EarlyContacts& one, const EarlyContacts& other)
{
  const std::size_t common = std::min(one.records.size(), other.records.size());
  for (std::size_t k = 0; k < common; ++k)
  {
    RC_ASSERT(std::abs(one.records[k].time - other.records[k].time) < 1e-7);
    RC_ASSERT(one.records[k].kind == other.records[k].kind);
    RC_ASSERT(std::abs(one.records[k].normal_impulse - other.records[k].normal_impulse) < 1e-6);
  }
  // What only one has, the other had no more time for.
  if (one.records.size() > common)
    RC_ASSERT(other.later < one.records[common].time);
  if (other.records.size() > common)
    RC_ASSERT(one.later < other.records[common].time);
  return common;
}

/// Contact by contact and disk by disk against the loop that tests everything.
TEST(Profile, MeetsTheSameCollisionsAsTheReference)
{
  EXPECT_TRUE(rc::check(
      []
      {
        SceneDefinition scene = drawnLayer();
        // At a corner an error grows by the flight over the radius.
        scene.species[0].radius = *rc::gen::element(0.001, 0.003);
        scene.base.drive_frame = *rc::gen::element(DriveFrame::WORLD, DriveFrame::BASE);
        if (*rc::gen::arbitrary<bool>())
          scene = test::onAnOrbit(scene);
        if (*rc::gen::arbitrary<bool>())
          scene = test::withSizes(scene);
        const std::size_t disks = 2 * static_cast<std::size_t>(scene.species[0].count);
        const auto fast = earlyContacts(profileCollisions(scene, 0.15, false), disks, 4);
        const auto slow = earlyContacts(profileCollisions(scene, 0.15, true), disks, 4);
        std::size_t contacts = 0;
        for (std::size_t disk = 0; disk < disks; ++disk)
          contacts += checkSame(fast[disk], slow[disk]);
        RC_CLASSIFY(contacts >= 3 * disks, "three contacts of each disk");
      }));
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

/// A disk wider than a gap rests on both of its edges, and never touches the bottom.
TEST(Profile, ADiskRestsOnTheEdgesOfAGap)
{
  SceneDefinition scene = test::mixture(0);
  scene.base.teeth = 3;
  scene.base.amplitude = 0.0;
  scene.base.profile = {{0.0, 0.0}, {0.009, 0.0}, {0.009, -0.01}, {0.011, -0.01}, {0.011, 0.0}, {0.02, 0.0}};
  scene.species[1].radius = 0.002;
  InitialDisk disk;
  disk.species = 1;
  disk.x = 0.03 + 0.0002;
  disk.y = 0.004;
  scene.initial = {disk};
  scene.contact.min_rebound_speed = 0.02;
  Simulation simulation(scene);
  simulation.advanceTo(1.0);
  EXPECT_NEAR(simulation.disks()[0].y, std::sqrt(0.002 * 0.002 - 0.001 * 0.001), 3e-4);
  EXPECT_NEAR(std::fmod(simulation.disks()[0].x, 0.02), 0.01, 3e-4);
  const FaceContacts& contacts = simulation.faceContacts();
  EXPECT_GT(contacts.corner_contacts[1], 0u);
  EXPECT_GT(contacts.corner_contacts[4], 0u);
  EXPECT_EQ(contacts.face_contacts[2], 0u);
}

}  // namespace
}  // namespace ratchet_sieve
