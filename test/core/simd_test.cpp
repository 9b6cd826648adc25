#include "simd/batch_rows.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "bench.h"
#include "draws.h"
#include "flights.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
TEST(Simd, TwoAreInEveryMachine)
{
  EXPECT_EQ(widestKernel(2).lanes, 2);
  EXPECT_EQ(widestKernel(3).lanes, 2);
}

TEST(Simd, AreLimitedByTheEnvironment)
{
  // The limit, or 0 if the run is refused.
  const auto limited = [](const std::string& text)
  {
    setenv("RATCHET_SIEVE_LANES", text.c_str(), 1);
    int limit = 0;
    try
    {
      Simulation simulation(test::singleParticles(1));
      limit = laneLimit();
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(error.what(), "environment variable RATCHET_SIEVE_LANES = " + text + ": must be 2, 4 or 8");
    }
    unsetenv("RATCHET_SIEVE_LANES");
    return limit;
  };
  EXPECT_EQ(laneLimit(), 8);
  EXPECT_EQ(limited("2"), 2);
  EXPECT_EQ(limited("8"), 8);
  for (const char* text : {"1", "3", "16", "", "04", "4 "})
    EXPECT_EQ(limited(text), 0) << text;
}

/// The scene with contact times, for which there is no SIMD, but no contact within so short a duration.
SceneDefinition withoutSimd(SceneDefinition scene)
{
  EXPECT_TRUE(planOf(scene).simd);
  scene.contact.contact_duration = 1e-300;
  return scene;
}

TEST(Simd, OnlyWhereThePlanHasThemAndTheBaseStandsAtItsSetpoints)
{
  const SceneDefinition scene = test::singleParticles(1);
  EXPECT_FALSE(batchScene(SystemState(withoutSimd(scene))));
  SystemState system(scene);
  EXPECT_TRUE(batchScene(system));
  system.changeMotion([](BaseMotion& motion, double now) { motion.command(Quantity::FREQUENCY, 30.0, now); },
                      0.1);
  EXPECT_FALSE(batchScene(system));
}

/// Before rounding errors grow, each disk follows the same path in both; the outcomes of all contacts are
/// compared as well.
TEST(Simd, GoTheSameWayAsTheMachine)
{
  std::vector<SceneDefinition> all = test::variantsForSimd();
  // For disks that come to rest, the final positions differ only by rounding.
  all.pop_back();
  for (SceneDefinition& scene : all)
  {
    scene.species[0].contact.restitution = 0.3;
    constexpr double FIRST_CONTACTS = 0.12;
    Simulation in_batches(scene);
    Simulation without(withoutSimd(scene));
    in_batches.advanceTo(FIRST_CONTACTS);
    without.advanceTo(FIRST_CONTACTS);
    const std::vector<DiskState> one = in_batches.disks();
    const std::vector<DiskState> other = without.disks();
    int apart = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      if (!(std::abs(one[i].displacement - other[i].displacement) < 1e-9 &&
            std::abs(one[i].y - other[i].y) < 1e-9 && std::abs(one[i].vx - other[i].vx) < 1e-7 &&
            std::abs(one[i].vy - other[i].vy) < 1e-7 && std::abs(one[i].angle - other[i].angle) < 1e-6 &&
            std::abs(one[i].spin - other[i].spin) < 1e-5 + 1e-9 / scene.species[one[i].species].radius))
        ++apart;
    // A flight that nearly grazes an apex may hit it in one version only.
    EXPECT_LE(apart, static_cast<int>(one.size()) / 50) << &scene - all.data();
    EXPECT_NEAR(in_batches.energy(), without.energy(), 1e-2 * std::abs(without.energy()));
  }
}

SceneDefinition drawnSceneForBatches()
{
  SceneDefinition scene = test::singleParticles(0);
  BaseDefinition& base = scene.base;
  base.teeth = 5;
  base.tooth_width = *rc::gen::element(0.02, 0.02, 0.0005, 0.2);
  base.tooth_height = *rc::gen::element(0.0, 0.05, 0.3, 3.0) * base.tooth_width;
  base.asymmetry = *rc::gen::element(0.0, 0.1, 0.3, 0.5, 0.9, 1.0);
  base.inclination = *rc::gen::element(0.0, 0.209, -0.1, 1.2, -1.5, 2.5);
  base.amplitude = *rc::gen::element(0.0, 0.002, 0.01);
  base.frequency = *rc::gen::element(0.0, 5.0, 23.0, 200.0);
  base.phase = drawn(0.0, 6.28);
  scene.gravity = *rc::gen::element(0.0, 9.81, 9.81);
  scene.species[0].radius = *rc::gen::element(1e-5, 0.001, 0.004, 0.009, 0.03);
  return scene;
}

/// A disk that starts anywhere free of the base, or touching it, in any direction.
Disk drawnDisk(const SystemState& system)
{
  const double radius = system.scene().species[0].radius * *rc::gen::element(1.0, 1.0, 0.7, 1.6);
  const double speed = *rc::gen::element(0.05, 0.5, 5.0);
  const bool down = *rc::gen::inRange(0, 3) == 0;
  return test::drawnFlight(system.motion(), system.shape(), radius, speed, down);
}

/// Searches from event to event until a contact is certain, as the loop does.
BaseEvent searchInBatch(const SystemState& system, const BatchKernel& kernel)
{
  const BatchScene scene = *batchScene(system);
  SimdBatch batch{};
  BaseEvent event{0.0, {}};
  loadRow(system, 0, event, batch, 0);
  const auto position = intoBase(scene.base, batch.x[0], batch.y[0]);
  const auto velocity = intoBase(scene.base, batch.vx[0], batch.vy[0]);
  batch.s[0] = position.first;
  batch.n[0] = position.second;
  batch.vs[0] = velocity.first;
  batch.vn[0] = velocity.second;
  for (int i = 0; i < 2000 && !event.feature && event.time < test::HORIZON; ++i)
  {
    kernel.search(scene, batch, 1);
    event = rowEvent(batch, 0);
  }
  return event;
}

ContactSearch searchOf(const SystemState& system)
{
  return {system.shape(), system.motion(), system.scene().gravity, timeResolution(system.epoch().length)};
}

bool isClear(const SystemState& system, const BaseEvent& event)
{
  if (!event.feature || event.time >= test::HORIZON)
    return false;
  const BasePoint point = searchOf(system).seenFromBase(system.disk(0), event.time);
  return system.shape().approach(event.feature, point, system.radius(0)).rate < -1e-2;
}

TEST(Simd, FindTheFirstContactOfRandomFlights)
{
  EXPECT_TRUE(rc::check(
      []
      {
        test::Bench bench(drawnSceneForBatches());
        test::addDisk(bench.state, drawnDisk(bench.state));
        const BatchKernel& kernel = widestKernel(*rc::gen::element(2, 8));
        const BaseEvent found = searchInBatch(bench.state, kernel);
        const Disk& disk = bench.state.disk(0);
        // The initial overlap of a disk of this size is rounding; positions are up to a few metres.
        const double tolerance = 1e-9 * disk.radius + 1e-14;
        test::checkAgainstScan(searchOf(bench.state), bench.state.shape(), disk, found, tolerance);
        const BaseEvent expected = test::searchOn(searchOf(bench.state), disk);
        // Rounding decides whether a grazing contact occurs.
        const bool clear = isClear(bench.state, found) && isClear(bench.state, expected);
        RC_CLASSIFY(!clear, "no contact, or a graze");
        RC_ASSERT(static_cast<bool>(found.feature) || !isClear(bench.state, expected));
        if (clear)
          RC_ASSERT(std::abs(found.time - expected.time) < 1e-12);
      }));
}

/// Compares the outcome of a row's event by SIMD and by the machine, field by field.
void expectSameOutcome(const ContactOutcome& row, const ContactOutcome& contact)
{
  constexpr double ROUNDING = 1e-11;
  RC_ASSERT(row.time == contact.time);
  RC_ASSERT(row.kind == contact.kind);
  RC_ASSERT(row.i == contact.i);
  RC_ASSERT(row.j == contact.j);
  RC_ASSERT(row.closed == contact.closed);
  RC_ASSERT(row.lossless == contact.lossless);
  RC_ASSERT(std::abs(row.overlap - contact.overlap) < ROUNDING);
  RC_ASSERT((row.normal - contact.normal).norm() < 1e-9);
  RC_ASSERT(std::abs(row.normal_velocity - contact.normal_velocity) < 1e-9);
  RC_ASSERT(std::abs(row.normal_impulse - contact.normal_impulse) < ROUNDING);
  RC_ASSERT(std::abs(row.tangential_impulse - contact.tangential_impulse) < ROUNDING);
}

/// A row with a random disk that starts on the base, or comes down to it.
TEST(Simd, HandOverTheSameOutcomesAsTheMachine)
{
  EXPECT_TRUE(rc::check(
      []
      {
        SceneDefinition scene = drawnSceneForBatches();
        scene.contact.restitution_speed = *rc::gen::element(0.0, 0.4);
        scene.contact.min_rebound_speed = *rc::gen::element(0.0, 0.05);
        test::Bench bench(scene);
        Disk disk = drawnDisk(bench.state);
        disk.spin = *rc::gen::element(0.0, -300.0, 40.0);
        test::addDisk(bench.state, disk);
        const BatchKernel& kernel = widestKernel(*rc::gen::element(2, 8));
        const BaseEvent event = searchInBatch(bench.state, kernel);
        const bool clear = isClear(bench.state, event);
        RC_CLASSIFY(!clear, "no contact, or a graze");
        if (!clear)
          return;
        const BatchScene batch_scene = *batchScene(bench.state);
        SimdBatch batch{};
        loadRow(bench.state, 0, event, batch, 0);
        kernel.collide(batch_scene, batch, 1);
        BaseInstant base(bench.state.motion());
        const ContactOutcome outcome = bench.execution.collideWithBase(0, event.feature, event.time, base);
        RC_ASSERT(outcome.closed);
        expectSameOutcome(outcomeOf(batch_scene, batch, 0, 0, 0), outcome);
        const Eigen::Vector2d impulse = bench.state.record(0).base_impulse;
        RC_ASSERT((Eigen::Vector2d(batch.impulse_x[0], batch.impulse_y[0]) - impulse).norm() < 1e-11);
      }));
}

}  // namespace
}  // namespace ratchet_sieve
