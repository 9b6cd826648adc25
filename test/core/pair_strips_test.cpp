#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "drawn_scene.h"
#include "events/engine.h"
#include "events/slot_queue.h"
#include "runs.h"

namespace ratchet_sieve
{
namespace
{

/// Small strips, for small layers.
StripSettings smallStrips()
{
  StripSettings strips;
  strips.disks_per_thread = strips.least_on_one_thread = 2;
  strips.disks_per_strip = 60;
  strips.columns_per_strip = 24;
  strips.margin = 2;
  strips.events_per_column = 0.3;
  return strips;
}

std::string bytesOf(Engine& engine)
{
  StateArchive state;
  engine.archive(state);
  return state.takeBytes();
}

/// Of a state's bytes, which would be too long for a message.
std::uint64_t hashOf(Engine& engine)
{
  return std::hash<std::string>()(bytesOf(engine));
}

/// A run by strips on some threads, or by a single queue, with all its collisions.
struct WatchedRun
{
  WatchedRun(const SceneDefinition& scene, std::size_t threads, const StripSettings& strips)
      : engine(scene, 0.0, PourObserver())
  {
    engine.setThreads(threads, strips);
    engine.state().log().observeCollisions([this](const CollisionRecord& record)
                                           { collisions.push_back(record); });
  }

  Engine engine;
  std::vector<CollisionRecord> collisions;
};

bool haveTheSame(const WatchedRun& one, const WatchedRun& other)
{
  return std::equal(one.collisions.begin(), one.collisions.end(), other.collisions.begin(),
                    other.collisions.end(), test::areSame);
}

StripSettings never()
{
  StripSettings strips;
  strips.disks_per_thread = strips.least_on_one_thread = SIZE_MAX / 1024;
  return strips;
}

/// A layer of about 130 columns.
SceneDefinition longLayer(Boundary boundary = Boundary::PERIODIC)
{
  SceneDefinition scene = test::mixture(200);
  scene.base.teeth = 26;
  scene.settle = 0.05;
  scene.boundary = boundary;
  scene.pour.drop_height = 0.002;
  return scene;
}

void changeSetpoints(Engine& engine, int k)
{
  engine.changeMotion(
      [=](BaseMotion& motion, double now)
      {
        motion.setSlewRates({0.05, 20.0, 0.01}, now);
        motion.command(Quantity::INCLINATION, k % 2 == 0 ? 0.002 : -0.001, now);
        motion.command(Quantity::FREQUENCY, 20.0 + k, now);
      });
}

void expectSameBits(const SceneDefinition& scene, bool commands)
{
  WatchedRun queue(scene, 1, never());
  WatchedRun one(scene, 1, smallStrips()), three(scene, 3, smallStrips());
  for (int k = 1; k <= 6; ++k)
  {
    for (WatchedRun* run : {&queue, &one, &three})
    {
      run->engine.advanceTo(0.05 * k);
      if (commands)
        changeSetpoints(run->engine, k);
    }
    ASSERT_EQ(hashOf(one.engine), hashOf(queue.engine)) << 0.05 * k << " s";
    ASSERT_EQ(hashOf(three.engine), hashOf(queue.engine)) << "3 threads, " << 0.05 * k << " s";
  }
  for (WatchedRun* strips : {&one, &three})
  {
    EXPECT_GT(strips->engine.eventsInStrips(), strips->engine.events() / 8);
    ASSERT_TRUE(haveTheSame(queue, *strips));
  }
}

TEST(PairStrips, HaveTheBitsOfASingleQueue)
{
  SceneDefinition fed = longLayer(Boundary::OPEN);
  fed.feed.rate = 40.0;
  fed.observe = observableNames();
  SceneDefinition sizes = longLayer();
  sizes.species[0].size.distribution = SizeDistribution::UNIFORM;
  sizes.species[0].size.spread = 0.5;
  sizes.contact.contact_duration = 1e-5;
  for (const SceneDefinition& scene : {longLayer(), longLayer(Boundary::WALLED), fed, sizes})
    expectSameBits(scene, false);
  expectSameBits(longLayer(), true);
}

/// Of any scene, cut at places and into windows drawn by chance, with so small margins that windows fail.
TEST(PairStrips, HaveTheBitsOfASingleQueueWhereverTheyAreCut)
{
  std::uint64_t events_in_strips = 0;
  EXPECT_TRUE(rc::check(
      [&]
      {
        SceneDefinition scene = test::drawnScene();
        scene.contact.pair_collisions = true;
        scene.species[0].count = *rc::gen::inRange(10, 60);
        StripSettings strips = smallStrips();
        strips.columns_per_strip = *rc::gen::inRange(6, 40);
        strips.disks_per_strip = *rc::gen::inRange(2, 30);
        strips.margin = *rc::gen::inRange(0, 5);
        strips.events_per_column = *rc::gen::element(0.05, 0.2, 1.0, 4.0);
        WatchedRun queue(scene, 1, never());
        WatchedRun cut(scene, *rc::gen::inRange<std::size_t>(1, 4), strips);
        const double stride = *rc::gen::element(0.003, 0.02, 0.1);
        const double short_of_it = *rc::gen::element(0.0, 0.02, 0.5);
        try
        {
          for (int k = 1; k <= 6; ++k)
          {
            queue.engine.advanceTo(stride * k);
            cut.engine.advanceTo(stride * (k - short_of_it));
            cut.engine.advanceTo(stride * k);
            RC_ASSERT(hashOf(queue.engine) == hashOf(cut.engine));
          }
        }
        catch (const StallError&)
        {
          RC_ASSERT_THROWS_AS(cut.engine.advanceTo(stride * 6), StallError);
          RC_ASSERT(hashOf(queue.engine) == hashOf(cut.engine));
        }
        RC_ASSERT(haveTheSame(queue, cut));
        events_in_strips += cut.engine.eventsInStrips();
      }));
  EXPECT_GT(events_in_strips, 0u);
}

TEST(SlotQueue, HasTheOrderOfASingleQueue)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const std::size_t count = 60;
        std::vector<std::uint32_t> places(count, SlotQueue::NONE);
        SlotQueue some(places);
        EventQueue all;
        all.resize(count);
        for (int step = 0; step < 300; ++step)
        {
          const auto slot = *rc::gen::inRange<std::uint32_t>(0, count);
          if (*rc::gen::inRange(0, 4) == 0)
          {
            if (places[slot] != SlotQueue::NONE)
              some.erase(slot);
            all.update(slot, EventQueue::NEVER);
          }
          else
          {
            const double time = *rc::gen::inRange(0, 10);  // so few that there are ties
            some.update(slot, time);
            all.update(slot, time);
          }
          RC_ASSERT(some.topTime() == all.topTime());
          if (all.topTime() < EventQueue::NEVER)
            RC_ASSERT(some.top() == all.top());
        }
      }));
}

}  // namespace
}  // namespace ratchet_sieve
