// What the observers of contacts record for given outcomes.
#include "state/event_log.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "bench.h"
#include "events/engine.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

ContactOutcome onBase(std::uint32_t slot, CollisionKind kind, double time = 0.0)
{
  ContactOutcome outcome;
  outcome.time = time;
  outcome.kind = kind;
  outcome.i = slot;
  outcome.normal = {0.6, 0.8};
  outcome.normal_velocity = -3.0;
  outcome.normal_impulse = 2.0;
  outcome.tangential_impulse = 1.0;
  outcome.overlap = -1e-12;
  outcome.closed = true;
  return outcome;
}

ContactOutcome ofPair(std::uint32_t i, std::uint32_t j, double time = 0.0)
{
  ContactOutcome outcome = onBase(i, CollisionKind::DISK_DISK, time);
  outcome.j = j;
  return outcome;
}

ContactOutcome opening(ContactOutcome outcome)
{
  outcome.closed = false;
  return outcome;
}

TEST(SystemState, KeepsTheImpulseThatTheBaseGaveToDisksThatAreGone)
{
  constexpr std::uint32_t GONE = 1024;
  const Eigen::Vector2d one(0.25, 0.5);
  SystemState system(test::openMixture(0));
  for (std::uint32_t slot = 0; slot < GONE + 2; ++slot)
  {
    test::addDisk(system, Disk());
    system.record(slot).base_impulse = one;
    if (slot > 0 && slot <= GONE)
      system.passEnd(slot, true, 0.0);
  }
  EXPECT_EQ(system.baseImpulse(), (GONE + 2) * one);
  ASSERT_TRUE(system.compact());
  EXPECT_EQ(system.disks().size(), 2u);
  EXPECT_EQ(system.record(1).base_impulse, one);
  EXPECT_EQ(system.baseImpulse(), (GONE + 2) * one);
  system.restart(0.0);
  EXPECT_EQ(system.baseImpulse(), Eigen::Vector2d(0.0, 0.0));
}

TEST(ContactExecution, KeepsTheTimesOfLastContactsOfBothPartnersAndTheImpulseOfTheBase)
{
  SceneDefinition scene = test::mixture(0);
  scene.contact.contact_duration = 0.125;
  test::Bench bench(scene);
  Disk disk;
  disk.position = {0.1, 0.5};
  const std::uint32_t a = test::addDisk(bench.state, disk);
  disk.position.x() += 0.9 * (bench.state.radius(a) + bench.state.radius(a));
  disk.velocity.x() = -1.0;
  const std::uint32_t b = test::addDisk(bench.state, disk);
  disk.position.y() = 0.7;
  const std::uint32_t c = test::addDisk(bench.state, disk);
  EXPECT_FALSE(bench.execution.collidePair(a, b, 0, 0.0).lossless);
  EXPECT_EQ(bench.state.record(a).last_contact, 0.0);
  EXPECT_EQ(bench.state.record(b).last_contact, 0.0);
  EXPECT_LT(bench.state.record(c).last_contact, -1e9);
  EXPECT_EQ(bench.state.baseImpulse(), Eigen::Vector2d(0.0, 0.0));
  bench.state.rebase(bench.state.epoch().length);
  EXPECT_EQ(bench.state.record(a).last_contact, -bench.state.epoch().length);
}

/// Those that close are in collision_law_test.cpp and simd_test.cpp.
TEST(ContactExecution, LeavesAContactAloneThatOpens)
{
  SceneDefinition scene = test::mixture(0);
  scene.base.amplitude = scene.base.tooth_height = 0.0;
  test::Bench bench(scene);
  BaseInstant base(bench.state.motion());
  Disk disk;
  disk.position = {0.002, 0.0008};
  disk.velocity = {2.0, 1.0};
  const std::uint32_t i = test::addDisk(bench.state, disk);
  disk.position.x() = 0.004;
  disk.velocity.x() = 3.0;
  disk.species = 1;
  const std::uint32_t j = test::addDisk(bench.state, disk);
  const BaseFeature ground{BaseFeatureKind::FACE, 0, 0};
  const ContactOutcome outcomes[] = {bench.execution.collideWithBase(i, ground, 0.0, base),
                                     bench.execution.collidePair(i, j, 0, 0.0)};
  EXPECT_NEAR(outcomes[0].overlap, 0.0002, 1e-15);
  EXPECT_NEAR(outcomes[1].overlap, 0.001, 1e-15);
  for (const ContactOutcome& outcome : outcomes)
  {
    EXPECT_FALSE(outcome.closed);
    EXPECT_EQ(outcome.normal_velocity, 0.0);
    EXPECT_EQ(outcome.normal_impulse, 0.0);
    EXPECT_EQ(outcome.tangential_impulse, 0.0);
  }
  EXPECT_EQ(bench.state.disk(i).velocity, Eigen::Vector2d(2.0, 1.0));
  EXPECT_EQ(bench.state.disk(j).velocity, Eigen::Vector2d(3.0, 1.0));
  // What is predicted of them stays.
  EXPECT_EQ(bench.state.disk(i).event_count, 0u);
  EXPECT_EQ(bench.state.disk(j).event_count, 0u);
}

TEST(Observers, TakeTheOverlapOfEveryContactAndCountWhatClosed)
{
  SystemState system(test::mixture(0));
  test::addDisk(system, Disk());
  ContactOutcome overlapping = opening(onBase(0, CollisionKind::WALL));
  overlapping.overlap = 1e-9;
  system.collided(overlapping);
  EXPECT_EQ(system.sums().contacts.counts.collisions.total(), 0u);
  EXPECT_EQ(system.sums().contacts.counts.max_overlap, 1e-9);
  EXPECT_EQ(system.baseImpulse(), Eigen::Vector2d(0.0, 0.0));
}

TEST(Observers, TellWhatClosedByIdsAndInTheRunsTime)
{
  constexpr std::uint32_t GONE = 1024;
  SystemState system(test::openMixture(0));
  const double local = system.startAt(1000.25);
  for (std::uint32_t disk = 0; disk < GONE + 2; ++disk)
    test::addDisk(system, Disk());
  for (std::uint32_t slot = 0; slot < GONE; ++slot)
    system.passEnd(slot, true, local);
  ASSERT_TRUE(system.compact());

  std::vector<CollisionRecord> told;
  system.log().observeCollisions([&](const CollisionRecord& collision) { told.push_back(collision); });
  system.collided(ofPair(0, 1, local));
  system.collided(opening(onBase(1, CollisionKind::WALL, local)));
  system.collided(onBase(1, CollisionKind::WALL, local));
  system.log().observeCollisions({});
  system.collided(onBase(1, CollisionKind::WALL, local));
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].time, 1000.25);
  EXPECT_EQ(told[0].kind, CollisionKind::DISK_DISK);
  EXPECT_EQ(told[0].i, GONE);
  EXPECT_EQ(told[0].j, GONE + 1);
  EXPECT_EQ(told[0].normal_speed, 3.0);
  EXPECT_EQ(told[0].normal_impulse, 2.0);
  EXPECT_EQ(told[0].tangential_impulse, 1.0);
  EXPECT_EQ(told[1].kind, CollisionKind::WALL);
  EXPECT_EQ(told[1].i, GONE + 1);
  EXPECT_FALSE(told[1].j);
  EXPECT_EQ(system.sums().contacts.counts.collisions.total(), 3u);
}

/// Times round when the zero of time is moved.
constexpr double ROUNDING = 1e-14;

/// Follows every disk from flight to flight, and adds up what the engine adds up, too, in the order in which
/// it is told.
class Follower final : public Observer
{
public:
  explicit Follower(const SystemState& system) : begins(system.disks().size()), system_(system) {}

  unsigned subscriptions() const override { return CONTACTS | FLIGHTS; }

  void collided(const ContactOutcome& outcome) override
  {
    inOrder(outcome.time);
    EXPECT_EQ(system_.disk(outcome.i).species, outcome.species);
    collisions.add(outcome.kind);
    if (system_.epoch().start + outcome.time < system_.scene().settle)
      return;
    contacts[outcome.species] += 1.0;
    if (outcome.j != ContactOutcome::BASE)
      contacts[system_.disk(outcome.j).species] += 1.0;
  }

  void entered(const Disk& /*disk*/, double time) override { begins.push_back(system_.epoch().start + time); }

  void flew(const Flight& flight) override
  {
    inOrder(flight.end);
    follow(flight.slot, flight.disk, flight.end);
    ++flights;
  }

  /// Takes a disk's flight up to a local time.
  void follow(std::uint32_t slot, const Disk& disk, double end)
  {
    const double begin = begins[system_.id(slot)] - system_.epoch().start;
    begins[system_.id(slot)] = system_.epoch().start + end;
    const double elapsed = end - begin;
    // Integrals of v^2 / 2 and of the spin's, by Simpson's rule, which is exact for parabolas.
    const auto square = [&](double time)
    { return 0.5 * vectorOf(kinematicsAt(disk, time, system_.scene().gravity).velocity).squaredNorm(); };
    translation += elapsed / 6.0 * (square(begin) + 4.0 * square(begin + 0.5 * elapsed) + square(end));
    rotation += 0.5 * elapsed * disk.spin * disk.spin;
  }

  void departed(const Departure& departure) override
  {
    inOrder(departure.time);
    EXPECT_NEAR(begins[system_.id(departure.slot)], system_.epoch().start + departure.time, ROUNDING);
    ++departures[static_cast<int>(departure.exit)];
  }

  void rebase(double length) override { last_ -= length; }

  CollisionCounts collisions;
  double contacts[2] = {};  ///< of each species since `settle`
  double translation = 0.0;
  double rotation = 0.0;
  std::size_t flights = 0;
  std::vector<double> begins;  ///< by id: of the present flight, in the run's time
  std::size_t departures[3] = {};

private:
  void inOrder(double time)
  {
    EXPECT_GE(time, last_);
    last_ = time;
  }

  const SystemState& system_;
  double last_ = -1.0;
};

struct Followed
{
  explicit Followed(const SceneDefinition& scene)
      : engine(scene, 0.0, {}), follower(engine.state().log().add(std::make_unique<Follower>(engine.state())))
  {
  }

  Engine engine;
  Follower* follower;
};

/// Layers, by events and by steps; single disks in SIMD batches, without, and in an open machine that is fed.
std::vector<SceneDefinition> scenesToFollow()
{
  SceneDefinition layer = test::mixture(20);
  layer.base.teeth = 3;
  SceneDefinition steps = layer;
  steps.accuracy.method = Method::STEPS;
  layer.settle = 0.7;
  SceneDefinition walled = test::singleParticles(20);
  walled.boundary = Boundary::WALLED;
  SceneDefinition singles = test::singleParticles(150);
  SceneDefinition fed = test::mixture(10);
  fed.base.teeth = 3;
  fed.base.inclination = 0.2;
  fed.boundary = Boundary::OPEN;
  fed.feed.rate = 50.0;
  SceneDefinition fed_singles = fed;
  fed_singles.contact.pair_collisions = false;
  return {layer, steps, fed, fed_singles, walled, singles};
}

TEST(Observers, AddedAreToldOfEveryContactFlightAndDepartureInTheOrderOfTime)
{
  for (const SceneDefinition& scene : scenesToFollow())
  {
    Followed followed(scene);
    Simulation unobserved(scene);
    constexpr double END = 4.5;
    followed.engine.advanceTo(END);
    unobserved.advanceTo(END);
    const SystemState& system = followed.engine.state();
    Follower& told = *followed.follower;
    // The run does not depend on it.
    EXPECT_EQ(followed.engine.events(), unobserved.events());
    EXPECT_EQ(told.collisions.total(), unobserved.collisions().total());
    EXPECT_EQ(told.collisions.left_slope, unobserved.collisions().left_slope);
    std::uint64_t left = 0, right = 0;
    for (const SpeciesBins& bins : unobserved.bins())
    {
      left += bins.left;
      right += bins.right;
    }
    EXPECT_EQ(told.departures[0], left);
    EXPECT_EQ(told.departures[1], right);
    EXPECT_EQ(told.departures[2], 0u);
    EXPECT_GT(told.flights, told.collisions.total() / 2);
    double translation = 0.0, rotation = 0.0;
    for (std::uint32_t slot = 0; slot < system.disks().size(); ++slot)
    {
      DiskRecord record = system.record(slot);
      if (record.active)
      {
        record.fly(system.disk(slot), followed.engine.now(), scene.gravity);
        told.follow(slot, system.disk(slot), followed.engine.now());
      }
      translation += record.translation;
      rotation += record.rotation;
    }
    // The sums begin anew at the end of `settle`.
    if (scene.settle == 0.0)
    {
      EXPECT_NEAR(told.translation, translation, 1e-9 * translation);
      EXPECT_NEAR(told.rotation, rotation, 1e-9 * rotation);
    }
    for (std::size_t s = 0; s < scene.species.size() && !scene.feed.any(); ++s)
      EXPECT_DOUBLE_EQ(*unobserved.means()[s].collision_rate,
                       told.contacts[s] / (scene.species[s].count * (END - scene.settle)));
  }
}

}  // namespace
}  // namespace ratchet_sieve
