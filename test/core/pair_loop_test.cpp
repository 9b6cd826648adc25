#include <algorithm>

#include <gtest/gtest.h>

#include "events/event_loop.h"
#include "reference_loop.h"
#include "scenes.h"
#include "state/placement.h"
#include "state/pour.h"

namespace ratchet_sieve
{
namespace
{

void fill(SystemState& system)
{
  Random random(system.scene().seed);
  pourDisks(system, pourOrder(system.scene().species, random), Stretch(), 0.0, random);
}

std::vector<CollisionRecord> collisionsOf(const SceneDefinition& scene, double end, bool reference)
{
  test::Bench bench(scene);
  fill(bench.state);
  std::vector<CollisionRecord> records;
  bench.state.observers().observeCollisions([&](const CollisionRecord& record)
                                            { records.push_back(record); });
  if (reference)
    test::ReferenceLoop(bench).advanceTo(end);
  else
  {
    const auto loop = makePairLoop(bench.state, bench.execution);
    for (std::uint32_t id = 0; id < bench.state.disks().size(); ++id)
      loop->added(id, 0.0);
    loop->advanceTo(end);
  }
  return records;
}

/// The two run the same physics with different rounding, and the system is chaotic: an error of 1e-16 grows
/// about tenfold with each collision of a disk. Over the first ten or so collisions of every disk they must
/// agree collision for collision.
void expectSameCollisions(const SceneDefinition& scene, double end, std::size_t count)
{
  const auto fast = collisionsOf(scene, end, false);
  const auto slow = collisionsOf(scene, end, true);
  ASSERT_GE(fast.size(), count);
  ASSERT_GE(slow.size(), count);
  const auto partners = [](const CollisionRecord& r)
  { return std::make_pair(std::min(r.i, r.j.value_or(r.i)), std::max(r.i, r.j.value_or(r.i))); };
  for (std::size_t k = 0; k < count; ++k)
  {
    ASSERT_NEAR(fast[k].time, slow[k].time, 1e-7) << "collision " << k;
    ASSERT_EQ(fast[k].kind, slow[k].kind) << "collision " << k;
    ASSERT_EQ(partners(fast[k]), partners(slow[k])) << "collision " << k;
  }
}

TEST(PairLoop, MeetsTheSameCollisionsAsTheReferencePeriodic)
{
  SceneDefinition scene = test::mixture(30);
  scene.base.teeth = 3;
  expectSameCollisions(scene, 0.08, 300);
}

TEST(PairLoop, MeetsTheSameCollisionsAsTheReferenceInclined)
{
  SceneDefinition scene = test::mixture(25);
  scene.base.teeth = 2;
  scene.base.inclination = 0.2;
  scene.seed = 7;
  expectSameCollisions(scene, 0.08, 250);
}

TEST(PairLoop, MeetsTheSameCollisionsAsTheReferenceOpen)
{
  SceneDefinition scene = test::openMixture(25);
  scene.base.teeth = 4;
  scene.seed = 3;
  expectSameCollisions(scene, 0.1, 250);
}

TEST(PairLoop, MeetsTheSameCollisionsAsTheReferenceWalled)
{
  SceneDefinition scene = test::mixture(25);
  scene.base.teeth = 2;
  scene.boundary = Boundary::WALLED;
  expectSameCollisions(scene, 0.08, 250);
}

TEST(PairLoop, MeetsTheSameCollisionsAsTheReferenceWithSizes)
{
  SceneDefinition scene = test::withSizes(test::mixture(30));
  scene.base.teeth = 3;
  expectSameCollisions(scene, 0.08, 300);
  scene.boundary = Boundary::WALLED;
  expectSameCollisions(scene, 0.08, 250);
  scene = test::withSizes(test::openMixture(25));
  scene.base.teeth = 6;
  expectSameCollisions(scene, 0.1, 200);
}

/// One disk 20 times as large as the others.
TEST(PairLoop, MeetsTheSameCollisionsAsTheReferenceWithAWideTable)
{
  SceneDefinition scene = test::mixture(30);
  scene.base.teeth = 4;
  scene.species[0].size = {SizeDistribution::TABLE, 0.0, 3.0, {0.0005, 0.01}, {30.0, 1.0}, SizeShare::NUMBER};
  scene.seed = 2;
  expectSameCollisions(scene, 0.08, 250);
}

TEST(PairLoop, ImagesAreSeenOnARingOfOneCell)
{
  // Two disks of 15 mm on a ring of 20 mm: each collides with the other on both sides.
  SceneDefinition scene = test::mixture(1);
  scene.base.teeth = 1;
  scene.species[0].radius = 0.0075;
  scene.species[1].radius = 0.0060;
  expectSameCollisions(scene, 0.3, 8);
}

}  // namespace
}  // namespace ratchet_sieve
