#include <random>
#include <string>

#include <gtest/gtest.h>

#include "profiles.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// A mixture over a base at rest that loses no energy.
SceneDefinition lossless(SceneDefinition scene, double friction, double tangential_restitution)
{
  scene.base.amplitude = 0.0;
  scene.contact.min_rebound_speed = 0.0;
  for (auto& species : scene.species)
    species.contact = {1.0, friction, tangential_restitution};
  scene.pour.drop_height = 0.05;
  return scene;
}

SceneDefinition smooth(const SceneDefinition& scene)
{
  return lossless(scene, 0.0, 0.0);
}

SceneDefinition perfectlyRough(const SceneDefinition& scene)
{
  return lossless(scene, 1e9, 1.0);
}

SceneDefinition onCastle(SceneDefinition scene, Boundary boundary, double inclination = 0.0)
{
  scene.base.profile = test::castle();
  scene.base.inclination = inclination;
  scene.boundary = boundary;
  scene.base.wall_height = 100.0;  // light disks are thrown high
  return scene;
}

/// If the frequency of a drive is 0, the base is at rest at its phase.
SceneDefinition onAnOrbitThatStandsStill()
{
  SceneDefinition scene = test::onAnOrbit(onCastle(perfectlyRough(test::mixture(15)), Boundary::WALLED, 0.1));
  scene.base.amplitude = 0.002;
  scene.base.frequency = 0.0;
  scene.base.phase = 1.0;
  return scene;
}

TEST(Conservation, LosslessDisksKeepTheirEnergyWithTheirSpins)
{
  const SceneDefinition mixture = test::mixture(100);
  SceneDefinition layer = test::mixture(65);
  layer.base.teeth = 5;
  const SceneDefinition sizes = test::withSizes(mixture);
  struct
  {
    const char* name;
    SceneDefinition scene;
    double duration;
    std::uint64_t collisions;
    double drift = 1e-10;
  } const cases[] = {
      {"perfectly rough", perfectlyRough(mixture), 250.0, 1000000},
      {"sizes", smooth(sizes), 100.0, 300000},
      {"sizes, perfectly rough", perfectlyRough(sizes), 100.0, 300000},
      {"sizes on a steep profile", onCastle(smooth(sizes), Boundary::WALLED, 0.4), 20.0, 50000},
      {"profile, perfectly rough", onCastle(perfectlyRough(mixture), Boundary::PERIODIC), 10.0, 20000},
      {"orbit that stands still", onAnOrbitThatStandsStill(), 1.0, 100, 1e-11},
      {"steps", test::bySteps(smooth(layer), 0.001), 2.0, 5000, 1e-9},
      {"steps, sizes", test::bySteps(smooth(test::withSizes(layer)), 0.001), 2.0, 5000, 1e-9}};
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.name);
    Simulation simulation(one.scene);
    const double start = simulation.energy();
    simulation.advanceTo(one.duration);
    EXPECT_GE(simulation.collisions().total(), one.collisions);
    EXPECT_EQ(simulation.pushedOut(), 0u);
    EXPECT_NEAR(simulation.energy() / start, 1.0, one.drift);
  }
}

/// Momentum, angular momentum about the origin and kinetic energy of all disks.
struct Motion
{
  double px = 0.0, py = 0.0, spin = 0.0, energy = 0.0;
};

Motion motionOf(const Simulation& simulation)
{
  Motion motion;
  for (const DiskState& disk : simulation.disks())
  {
    const SpeciesDefinition& species = simulation.scene().species[disk.species];
    const double mass = species.massOf(disk.radius);
    const double inertia = species.inertiaOf(mass, disk.radius);
    motion.px += mass * disk.vx;
    motion.py += mass * disk.vy;
    motion.spin += mass * (disk.x * disk.vy - disk.y * disk.vx) + inertia * disk.spin;
    motion.energy +=
        0.5 * mass * (disk.vx * disk.vx + disk.vy * disk.vy) + 0.5 * inertia * disk.spin * disk.spin;
  }
  return motion;
}

/// Rough disks that lose energy, 1:10 in size, in a cloud that falls in on itself, far from the base.
TEST(Conservation, ContactsOfDisksKeepMomentumAndAngularMomentum)
{
  SceneDefinition scene;
  scene.base.teeth = 100;
  scene.boundary = Boundary::OPEN;
  scene.gravity = 0.0;
  for (int k = 0; k < 10; ++k)
  {
    scene.species.push_back(test::disksOfSize(0.3 + 0.3 * k, 0));
    scene.species.back().contact = {0.1 * k, 0.3, -0.8 + 0.15 * k};
    scene.species.back().inertia_factor = 0.1 + 0.05 * k;
  }
  std::mt19937 random(1);
  const auto uniform = [&random](double largest) { return largest * (random() / 2147483648.0 - 1.0); };
  for (int k = 0; k < 400; ++k)
  {
    const double x = 0.01 * (k % 20 - 9.5), y = 0.01 * (k / 20 - 9.5);
    scene.initial.push_back({static_cast<std::size_t>(random() % 10), 1.0 + x, 0.5 + y,
                             -3.0 * x + uniform(0.2), -3.0 * y + uniform(0.2), uniform(50.0)});
  }
  Simulation simulation(scene);
  const Motion before = motionOf(simulation);
  simulation.advanceTo(0.5);
  const Motion after = motionOf(simulation);
  EXPECT_EQ(simulation.activeDisks(), 400u);
  EXPECT_EQ(simulation.collisions().total(), simulation.collisions().disk_disk);
  EXPECT_GT(simulation.collisions().disk_disk, 1000u);
  const double momentum = 400 * 0.001 * 1.0;
  EXPECT_NEAR(after.px, before.px, 1e-12 * momentum);
  EXPECT_NEAR(after.py, before.py, 1e-12 * momentum);
  EXPECT_NEAR(after.spin, before.spin, 1e-12 * momentum);
  EXPECT_LT(after.energy, 0.9 * before.energy);
}

enum class Loop
{
  PAIRS,
  SINGLES,
  SIMD_BATCHES,  ///< where the scene allows them
  STEPS
};

/// Disks of many sizes, on a profile and an orbit unless that keeps them from SIMD batches.
SceneDefinition sizedScene(Loop loop, Boundary boundary, DriveFrame frame)
{
  SceneDefinition scene = test::withSizes(test::mixture(30));
  scene.boundary = boundary;
  scene.base.inclination = 0.1;
  scene.base.drive_frame = frame;
  scene.contact.pair_collisions = loop == Loop::PAIRS || loop == Loop::STEPS;
  if (loop != Loop::SIMD_BATCHES)
    scene = test::onProfile(test::onAnOrbit(scene), test::castle());
  return loop == Loop::STEPS ? test::bySteps(scene, 0.001) : scene;
}

/// What the base gives is what weight and momentum take, to the last digits.
void expectBalance(const SceneDefinition& scene)
{
  constexpr double DURATION = 3.0;
  Simulation simulation(scene);
  const Motion before = motionOf(simulation);
  simulation.advanceTo(DURATION);
  const Motion after = motionOf(simulation);
  double weight = 0.0;
  for (const DiskState& disk : simulation.disks())
    weight += scene.species[disk.species].massOf(disk.radius) * scene.gravity;
  ASSERT_EQ(simulation.activeDisks(), 60u);
  EXPECT_GT(simulation.collisions().total(), 1000u);
  const double impulse = weight * DURATION;
  EXPECT_NEAR(simulation.baseImpulse().x(), after.px - before.px, 1e-11 * impulse);
  EXPECT_NEAR(simulation.baseImpulse().y(), after.py - before.py + impulse, 1e-11 * impulse);
}

TEST(Conservation, TheBasesImpulseIsTheChangeOfMomentum)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::WALLED})
    for (const DriveFrame frame : {DriveFrame::WORLD, DriveFrame::BASE})
      for (const Loop loop : {Loop::PAIRS, Loop::SINGLES, Loop::SIMD_BATCHES, Loop::STEPS})
      {
        SCOPED_TRACE(std::to_string(static_cast<int>(loop)) +
                     (boundary == Boundary::WALLED ? ", walled" : "") +
                     (frame == DriveFrame::BASE ? ", drive of the deck" : ""));
        expectBalance(sizedScene(loop, boundary, frame));
      }
  EXPECT_TRUE(planOf(sizedScene(Loop::SIMD_BATCHES, Boundary::PERIODIC, DriveFrame::WORLD)).simd);
}

}  // namespace
}  // namespace ratchet_sieve
