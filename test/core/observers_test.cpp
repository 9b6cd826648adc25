// What the observers of contacts record for given outcomes.
#include "state/observers.h"

#include <gtest/gtest.h>

#include "add_disk.h"
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

TEST(ContactCounts, CountWhatClosedByKindAndAllOverlaps)
{
  ContactCounts counts;
  const CollisionKind kinds[] = {CollisionKind::DISK_DISK, CollisionKind::LEFT_SLOPE,
                                 CollisionKind::RIGHT_SLOPE, CollisionKind::APEX, CollisionKind::WALL};
  std::size_t times = 0;
  for (const CollisionKind kind : kinds)
  {
    ++times;
    for (std::size_t k = 0; k < times; ++k)
      counts.take(onBase(0, kind));
  }
  EXPECT_EQ(counts.max_overlap, 0.0);
  ContactOutcome overlapping = opening(onBase(0, CollisionKind::WALL));
  overlapping.overlap = 1e-9;
  counts.take(overlapping);
  EXPECT_EQ(counts.collisions.disk_disk, 1u);
  EXPECT_EQ(counts.collisions.left_slope, 2u);
  EXPECT_EQ(counts.collisions.right_slope, 3u);
  EXPECT_EQ(counts.collisions.apex, 4u);
  EXPECT_EQ(counts.collisions.wall, 5u);
  EXPECT_EQ(counts.max_overlap, 1e-9);
}

TEST(BaseImpulses, AreThoseOfContactsWithTheBaseInTheWorld)
{
  BaseImpulses impulses;
  for (int disk = 0; disk < 3; ++disk)
    impulses.added();
  impulses.take(onBase(0, CollisionKind::APEX));
  impulses.take(onBase(2, CollisionKind::APEX));
  impulses.take(ofPair(0, 1));
  // J_n n + J_t t with t = (-0.8, 0.6).
  const Eigen::Vector2d one(2.0 * 0.6 - 0.8, 2.0 * 0.8 + 0.6);
  EXPECT_NEAR((impulses.of(0) - one).norm(), 0.0, 1e-15);
  EXPECT_EQ(impulses.of(1), Eigen::Vector2d(0.0, 0.0));
  EXPECT_NEAR((impulses.total() - 2.0 * one).norm(), 0.0, 1e-15);

  impulses.keep({1, 2}, {0});
  EXPECT_TRUE(impulses.fits(2));
  EXPECT_EQ(impulses.of(0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_NEAR((impulses.of(1) - one).norm(), 0.0, 1e-15);
  EXPECT_NEAR((impulses.total() - 2.0 * one).norm(), 0.0, 1e-15);
  impulses.restart();
  EXPECT_EQ(impulses.total(), Eigen::Vector2d(0.0, 0.0));
}

TEST(ContactTimes, AreThoseOfBothPartners)
{
  ContactTimes times(true);
  for (int disk = 0; disk < 3; ++disk)
    times.added();
  times.take(ofPair(0, 2, 1.0));
  times.take(onBase(2, CollisionKind::APEX, 1.5));
  EXPECT_TRUE(times.within(0.3, 0, 1.25));
  EXPECT_FALSE(times.within(0.25, 0, 1.25));
  EXPECT_FALSE(times.within(1e9, 1, 1.25));
  EXPECT_TRUE(times.within(0.3, 2, 1.75));
  times.rebase(1.0);
  EXPECT_TRUE(times.within(0.3, 0, 0.25));
  EXPECT_FALSE(times.within(0.3, 0, 1.25));
  times.keep({2});
  EXPECT_TRUE(times.within(0.3, 0, 0.75));

  ContactTimes none(false);
  none.added();
  none.take(onBase(0, CollisionKind::APEX, 1.0));
  EXPECT_FALSE(none.within(1e9, 0, 1.0));
}

TEST(Observers, TellsWhatClosedByIdsAndInTheRunsTime)
{
  SystemState machine(test::mixture(0));
  const double local = machine.startAt(1000.25);
  Observers record(machine);
  for (int disk = 0; disk < 3; ++disk)
  {
    test::addDisk(machine, Disk());
    record.added();
  }
  machine.remove(0, local);
  record.keep(machine.slots(true), machine.slots(false));
  machine.compact(machine.slots(true));

  std::vector<CollisionRecord> told;
  record.observeCollisions([&](const CollisionRecord& collision) { told.push_back(collision); });
  record.take(ofPair(0, 1, local));
  record.take(opening(onBase(1, CollisionKind::WALL, local)));
  record.take(onBase(1, CollisionKind::WALL, local));
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].time, 1000.25);
  EXPECT_EQ(told[0].kind, CollisionKind::DISK_DISK);
  EXPECT_EQ(told[0].i, 1u);
  EXPECT_EQ(told[0].j, 2u);
  EXPECT_EQ(told[0].normal_speed, 3.0);
  EXPECT_EQ(told[0].normal_impulse, 2.0);
  EXPECT_EQ(told[0].tangential_impulse, 1.0);
  EXPECT_EQ(told[1].kind, CollisionKind::WALL);
  EXPECT_EQ(told[1].i, 2u);
  EXPECT_FALSE(told[1].j);
  EXPECT_EQ(record.counts().collisions.total(), 2u);
}

}  // namespace
}  // namespace ratchet_sieve
