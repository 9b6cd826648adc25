// Outcomes of executed contacts, compared with values computed by hand.
#include "state/contact_execution.h"

#include <gtest/gtest.h>

#include "bench.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double SPEED = 1.0;
constexpr double RADIUS = 0.001;

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

/// A sawtooth base at rest.
SceneDefinition resting(Boundary boundary)
{
  SceneDefinition scene = test::mixture(0);
  scene.boundary = boundary;
  scene.base.inclination = 0.0;
  scene.base.amplitude = 0.0;
  return scene;
}

/// The same without teeth.
SceneDefinition flat()
{
  SceneDefinition scene = resting(Boundary::PERIODIC);
  scene.base.tooth_height = 0.0;
  return scene;
}

constexpr BaseFeature GROUND{BaseFeatureKind::FACE, 0, 0};

TEST(ContactExecution, SaysOfASlidingDiskOnTheBaseWhatItIsGiven)
{
  const SceneDefinition scene = flat();
  ContactBench bench(scene);
  const std::uint32_t slot = bench.add({0.002, 0.0009}, {2.0, -SPEED});
  const ContactOutcome outcome = bench.execution.collideWithBase(slot, GROUND, 0.0, bench.base);
  EXPECT_EQ(outcome.time, 0.0);
  EXPECT_EQ(outcome.kind, CollisionKind::LEFT_SLOPE);
  EXPECT_EQ(outcome.i, slot);
  EXPECT_EQ(outcome.j, ContactOutcome::BASE);
  EXPECT_TRUE(outcome.closed);
  EXPECT_FALSE(outcome.lossless);
  EXPECT_EQ(outcome.normal, Eigen::Vector2d(0.0, 1.0));
  EXPECT_EQ(outcome.normal_velocity, -SPEED);
  EXPECT_NEAR(outcome.overlap, 0.0001, 1e-15);
  // J_n = (1 + e) m v, and the surface slides: J_t = mu J_n, along (-1, 0).
  EXPECT_NEAR(outcome.normal_impulse, 1.6 * 0.010 * SPEED, 1e-15);
  EXPECT_NEAR(outcome.tangential_impulse, 0.1 * 1.6 * 0.010 * SPEED, 1e-15);
  EXPECT_NEAR(bench.velocity(slot).x(), 2.0 - 0.16 * SPEED, 1e-14);
  EXPECT_NEAR(bench.velocity(slot).y(), 0.6 * SPEED, 1e-14);
  // r / I = 2 / (m r).
  EXPECT_NEAR(bench.state.disk(slot).spin, -2.0 * 0.16 * SPEED / RADIUS, 1e-9);
  EXPECT_EQ(bench.state.disk(slot).event_count, 1u);
}

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
  // Their flights are nevertheless predicted again.
  EXPECT_EQ(bench.state.disk(i).event_count, 2u);
  EXPECT_EQ(bench.state.disk(j).event_count, 1u);
}

TEST(ContactExecution, SaysWhatOfTheBaseWasHit)
{
  struct Case
  {
    Boundary boundary;
    BaseFeature feature;
    Eigen::Vector2d velocity;
    CollisionKind expected;
  };
  const Eigen::Vector2d down(0.0, -SPEED);
  const Case cases[] = {
      {Boundary::PERIODIC, {BaseFeatureKind::FACE, 0, 0}, down, CollisionKind::LEFT_SLOPE},
      {Boundary::PERIODIC, {BaseFeatureKind::FACE, 0, 1}, down, CollisionKind::RIGHT_SLOPE},
      {Boundary::PERIODIC, {BaseFeatureKind::CORNER, 0, 1}, down, CollisionKind::APEX},
      {Boundary::OPEN, {BaseFeatureKind::END_CORNER, 0}, down, CollisionKind::APEX},
      {Boundary::WALLED, {BaseFeatureKind::END_CORNER, 0}, {-SPEED, -SPEED}, CollisionKind::WALL},
      {Boundary::WALLED, {BaseFeatureKind::LEFT_WALL, 0}, {-SPEED, 0.0}, CollisionKind::WALL},
      {Boundary::WALLED, {BaseFeatureKind::RIGHT_WALL, 0}, {SPEED, 0.0}, CollisionKind::WALL}};
  for (const Case& c : cases)
  {
    ContactBench bench(resting(c.boundary));
    // Above all of the first tooth and its corners, and above the walls.
    const std::uint32_t slot = bench.add({0.006, 100.0}, c.velocity);
    const ContactOutcome outcome = bench.execution.collideWithBase(slot, c.feature, 0.0, bench.base);
    EXPECT_EQ(outcome.kind, c.expected) << static_cast<int>(c.feature.kind());
    EXPECT_TRUE(outcome.closed) << static_cast<int>(c.feature.kind());
    EXPECT_NEAR(outcome.normal.norm(), 1.0, 1e-15);
    EXPECT_LT(outcome.normal.dot(c.velocity), 0.0);
    // Walls are smooth.
    if (c.expected == CollisionKind::WALL)
    {
      EXPECT_EQ(outcome.tangential_impulse, 0.0);
    }
  }
}

TEST(ContactExecution, SaysOfAPairAcrossTheSeamWhatBothAreGiven)
{
  const SceneDefinition scene = flat();
  ContactBench bench(scene);
  const double width = scene.base.width();
  const std::uint32_t i = bench.add({0.001, 0.1}, {-SPEED, 0.0}, 0);
  const std::uint32_t j = bench.add({width - 0.0019, 0.1}, {0.0, 0.0}, 1);
  const ContactOutcome outcome = bench.execution.collidePair(i, j, -1, 0.0);
  EXPECT_EQ(outcome.kind, CollisionKind::DISK_DISK);
  EXPECT_EQ(outcome.i, i);
  EXPECT_EQ(outcome.j, j);
  EXPECT_TRUE(outcome.closed);
  EXPECT_NEAR(outcome.normal.x(), 1.0, 1e-15);
  EXPECT_NEAR(outcome.normal.y(), 0.0, 1e-15);
  EXPECT_NEAR(outcome.overlap, 0.0001, 1e-15);
  EXPECT_NEAR(outcome.normal_velocity, -SPEED, 1e-15);
  // J_n = (1 + e) m_n v with 1 / m_n = 1 / 10 g + 1 / 1 g.
  const double impulse = 1.6 * (0.010 * 0.001 / 0.011) * SPEED;
  EXPECT_NEAR(outcome.normal_impulse, impulse, 1e-15);
  EXPECT_NEAR(outcome.tangential_impulse, 0.0, 1e-15);
  EXPECT_NEAR(bench.velocity(i).x(), -SPEED + impulse / 0.010, 1e-13);
  EXPECT_NEAR(bench.velocity(j).x(), -impulse / 0.001, 1e-13);
}

TEST(ContactExecution, LosesNothingAfterACollapseAndPartsNoSlowerThanItsFloor)
{
  SceneDefinition scene = flat();
  scene.contact.on_collapse = CollapseAction::REBOUND;
  scene.contact.collapse_events = 1;
  scene.contact.min_rebound_speed = 0.05;
  ContactBench bench(scene);
  const std::uint32_t slot = bench.add({0.002, RADIUS}, {2.0, -0.01});
  while (!bench.state.collapseWatch().count(slot, 0.0))
    continue;
  const ContactOutcome outcome = bench.execution.collideWithBase(slot, GROUND, 0.0, bench.base);
  EXPECT_TRUE(outcome.lossless);
  EXPECT_EQ(outcome.tangential_impulse, 0.0);
  EXPECT_NEAR(bench.velocity(slot).y(), 0.05, 1e-15);
}

}  // namespace
}  // namespace ratchet_sieve
