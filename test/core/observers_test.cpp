// What the observers of contacts record for given outcomes.
#include "state/observers.h"

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

TEST(BaseImpulses, AreThoseOfContactsWithTheBaseInTheWorld)
{
  BaseImpulses impulses;
  for (int disk = 0; disk < 3; ++disk)
    impulses.entered(Disk(), 0.0);
  impulses.collided(onBase(0, CollisionKind::APEX));
  impulses.collided(onBase(2, CollisionKind::APEX));
  impulses.collided(ofPair(0, 1));
  // J_n n + J_t t with t = (-0.8, 0.6).
  const Eigen::Vector2d one(2.0 * 0.6 - 0.8, 2.0 * 0.8 + 0.6);
  EXPECT_NEAR((impulses.of(0) - one).norm(), 0.0, 1e-15);
  EXPECT_EQ(impulses.of(1), Eigen::Vector2d(0.0, 0.0));
  EXPECT_NEAR((impulses.total() - 2.0 * one).norm(), 0.0, 1e-15);

  impulses.compact({{1, 2}, {0}});
  EXPECT_TRUE(impulses.fits(2));
  EXPECT_EQ(impulses.of(0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_NEAR((impulses.of(1) - one).norm(), 0.0, 1e-15);
  EXPECT_NEAR((impulses.total() - 2.0 * one).norm(), 0.0, 1e-15);
  impulses.restart(0.0);
  EXPECT_EQ(impulses.total(), Eigen::Vector2d(0.0, 0.0));
}

TEST(ContactTimes, AreThoseOfBothPartners)
{
  ContactTimes times(true);
  for (int disk = 0; disk < 3; ++disk)
    times.entered(Disk(), 0.0);
  times.collided(ofPair(0, 2, 1.0));
  times.collided(onBase(2, CollisionKind::APEX, 1.5));
  EXPECT_TRUE(times.within(0.3, 0, 1.25));
  EXPECT_FALSE(times.within(0.25, 0, 1.25));
  EXPECT_FALSE(times.within(1e9, 1, 1.25));
  EXPECT_TRUE(times.within(0.3, 2, 1.75));
  times.rebase(1.0);
  EXPECT_TRUE(times.within(0.3, 0, 0.25));
  EXPECT_FALSE(times.within(0.3, 0, 1.25));
  times.compact({{2}, {}});
  EXPECT_TRUE(times.within(0.3, 0, 0.75));

  ContactTimes none(false);
  none.entered(Disk(), 0.0);
  none.collided(onBase(0, CollisionKind::APEX, 1.0));
  EXPECT_FALSE(none.within(1e9, 0, 1.0));
}

TEST(Observers, TakeTheOverlapOfEveryContactAndCountWhatClosed)
{
  SystemState system(test::mixture(0));
  test::addDisk(system, Disk());
  ContactOutcome overlapping = opening(onBase(0, CollisionKind::WALL));
  overlapping.overlap = 1e-9;
  system.observers().collided(overlapping);
  EXPECT_EQ(system.observers().counts().collisions.total(), 0u);
  EXPECT_EQ(system.observers().counts().max_overlap, 1e-9);
  EXPECT_EQ(system.observers().impulses().total(), Eigen::Vector2d(0.0, 0.0));
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
  Observers& observers = system.observers();
  observers.observeCollisions([&](const CollisionRecord& collision) { told.push_back(collision); });
  observers.collided(ofPair(0, 1, local));
  observers.collided(opening(onBase(1, CollisionKind::WALL, local)));
  observers.collided(onBase(1, CollisionKind::WALL, local));
  observers.observeCollisions({});
  observers.collided(onBase(1, CollisionKind::WALL, local));
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
  EXPECT_EQ(observers.counts().collisions.total(), 3u);
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

  void left(const Departure& departure) override
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
      : engine(scene, 0.0, {}),
        follower(engine.state().observers().add(std::make_unique<Follower>(engine.state())))
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
      const TrajectorySums& trajectories = system.observers().trajectories();
      Trajectory trajectory = trajectories[slot];
      if (system.active(slot))
      {
        trajectory = trajectories.until(slot, system.disk(slot), followed.engine.now());
        told.follow(slot, system.disk(slot), followed.engine.now());
      }
      translation += trajectory.translation;
      rotation += trajectory.rotation;
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
