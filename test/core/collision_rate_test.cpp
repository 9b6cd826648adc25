#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

constexpr double SETTLE = 0.25;  // s
constexpr double END = 1.0;      // s

/// Contacts that the disks of each species took part in after SETTLE, from the records of the collisions.
class CountedContacts
{
public:
  explicit CountedContacts(Simulation& simulation) : contacts_(simulation.scene().species.size())
  {
    for (const DiskState& disk : simulation.disks())
      species_[disk.id] = disk.species;
    simulation.observeCollisions([this](const CollisionRecord& record) { take(record); });
  }

  double rate(std::uint32_t species, std::size_t disks) const
  {
    return static_cast<double>(contacts_[species]) / (static_cast<double>(disks) * (END - SETTLE));
  }

  std::uint64_t total() const
  {
    std::uint64_t sum = 0;
    for (const std::uint64_t contacts : contacts_)
      sum += contacts;
    return sum;
  }

private:
  void take(const CollisionRecord& record)
  {
    if (record.time < SETTLE)
      return;
    ++contacts_[species_.at(record.i)];
    if (record.j)
      ++contacts_[species_.at(*record.j)];
  }

  std::map<std::uint32_t, std::uint32_t> species_;  ///< by the disk's id
  std::vector<std::uint64_t> contacts_;
};

SceneDefinition settled(SceneDefinition scene)
{
  scene.settle = SETTLE;
  scene.duration = END;
  return scene;
}

SceneDefinition twoEnsembles()
{
  SceneDefinition scene = test::singleParticles(70);
  scene.species.push_back(scene.species[0]);
  scene.species[1].name = "B";
  scene.species[1].radius *= 2.0;
  scene.species[1].count = 30;
  return settled(scene);
}

void expectCounted(Simulation& simulation)
{
  const CountedContacts counted(simulation);
  simulation.advanceTo(END);
  ASSERT_GT(counted.total(), 500u);
  for (std::uint32_t i = 0; i < simulation.scene().species.size(); ++i)
    EXPECT_DOUBLE_EQ(simulation.means()[i].collision_rate.value(),
                     counted.rate(i, simulation.scene().species[i].count))
        << simulation.scene().species[i].name;
}

TEST(CollisionRate, CountsEachDiskOfAPair)
{
  Simulation simulation(settled(test::mixture(20)));
  expectCounted(simulation);
  EXPECT_GT(simulation.collisions().disk_disk, 100u);
}

TEST(CollisionRate, IsOfEachSpeciesOfAnEnsemble)
{
  const SceneDefinition scene = twoEnsembles();
  Simulation in_batches(scene);
  ASSERT_TRUE(in_batches.plan().simd);
  expectCounted(in_batches);
  Plan plan = planOf(scene);
  plan.simd = false;
  Simulation without(scene, plan);
  expectCounted(without);
}

}  // namespace
}  // namespace ratchet_sieve
