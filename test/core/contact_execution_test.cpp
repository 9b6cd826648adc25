// What a contact that opens leaves alone; those that close are in collision_law_test.cpp and simd_test.cpp.
#include "state/contact_execution.h"

#include <gtest/gtest.h>

#include "bench.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double SPEED = 1.0;

struct ContactBench : test::Bench
{
  explicit ContactBench(const SceneDefinition& scene) : test::Bench(scene), base(state.motion()) {}

  std::uint32_t add(const Eigen::Vector2d& place, const Eigen::Vector2d& velocity, std::uint32_t species = 0)
  {
    Disk disk;
    disk.position = place;
    disk.velocity = velocity;
    disk.species = species;
    return test::addDisk(state, disk);
  }

  const Eigen::Vector2d& velocity(std::uint32_t slot) const { return state.disk(slot).velocity; }

  BaseInstant base;
};

/// A base at rest without teeth.
SceneDefinition flat()
{
  SceneDefinition scene = test::mixture(0);
  scene.base.amplitude = 0.0;
  scene.base.tooth_height = 0.0;
  return scene;
}

constexpr BaseFeature GROUND{BaseFeatureKind::FACE, 0, 0};

TEST(ContactExecution, LeavesAContactAloneThatOpens)
{
  ContactBench bench(flat());
  const std::uint32_t i = bench.add({0.002, 0.0008}, {2.0, SPEED});
  const ContactOutcome base = bench.execution.collideWithBase(i, GROUND, 0.0, bench.base);
  EXPECT_FALSE(base.closed);
  EXPECT_NEAR(base.overlap, 0.0002, 1e-15);
  EXPECT_EQ(base.normal_velocity, 0.0);
  EXPECT_EQ(base.normal_impulse, 0.0);
  EXPECT_EQ(base.tangential_impulse, 0.0);
  EXPECT_EQ(bench.velocity(i), Eigen::Vector2d(2.0, SPEED));

  const std::uint32_t j = bench.add({0.004, 0.0008}, {3.0, SPEED}, 1);
  const ContactOutcome pair = bench.execution.collidePair(i, j, 0, 0.0);
  EXPECT_FALSE(pair.closed);
  EXPECT_NEAR(pair.overlap, 0.001, 1e-15);
  EXPECT_EQ(pair.normal_impulse, 0.0);
  EXPECT_EQ(bench.velocity(i), Eigen::Vector2d(2.0, SPEED));
  EXPECT_EQ(bench.velocity(j), Eigen::Vector2d(3.0, SPEED));
  // What is predicted of them stays.
  EXPECT_EQ(bench.state.disk(i).event_count, 0u);
  EXPECT_EQ(bench.state.disk(j).event_count, 0u);
}

}  // namespace
}  // namespace ratchet_sieve
