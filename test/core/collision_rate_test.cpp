#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// The mean rate of each species is that of the contacts, counted from their records, in which its disks took
/// part since `settle`.
void expectCounted(SceneDefinition scene, bool simd)
{
  constexpr double SETTLE = 0.25, END = 1.0;  // s
  scene.settle = SETTLE;
  Plan plan = planOf(scene);
  EXPECT_TRUE(plan.simd || !simd);
  plan.simd = simd;
  Simulation simulation(scene, plan);
  std::map<std::uint32_t, std::uint32_t> species;  // by the disk's id
  for (const DiskState& disk : simulation.disks())
    species[disk.id] = disk.species;
  std::vector<std::uint64_t> contacts(scene.species.size());
  for (const CollisionRecord& record : test::collisionsUntil(simulation, END))
    if (record.time >= SETTLE)
    {
      ++contacts[species.at(record.i)];
      if (record.j)
        ++contacts[species.at(*record.j)];
    }
  EXPECT_EQ(simulation.collisions().disk_disk > 100u, scene.contact.pair_collisions);
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    ASSERT_GT(contacts[i], 200u);
    EXPECT_DOUBLE_EQ(*simulation.means()[i].collision_rate,
                     static_cast<double>(contacts[i]) / (scene.species[i].count * (END - SETTLE)));
  }
}

TEST(CollisionRate, CountsEachDiskOfAPairAndEachSpecies)
{
  SceneDefinition scene = test::mixture(20);
  expectCounted(scene, false);
  scene.contact.pair_collisions = false;
  scene.species[0].count = 70;
  expectCounted(scene, true);
  expectCounted(scene, false);
}

}  // namespace
}  // namespace ratchet_sieve
