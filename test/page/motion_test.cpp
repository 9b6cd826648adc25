// How a motion is thinned. That a page shows the recorded positions is seen in browsers:
// browsers/positions_test.js.
#include "motion.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ratchet_sieve/recording/headless_run.h"
#include "recording/small_scenes.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::size_t PLENTY = 10'000'000;

/// Records a run, 240 frames a second. @return what is encoded of it in a size
EncodedMotion motionOf(const SceneDefinition& scene, std::size_t size, std::size_t most_bytes = PLENTY)
{
  struct Sink : FrameSink
  {
    Sink(const SceneDefinition& scene, std::size_t most_bytes) : record(scene, most_bytes) {}
    void take(const AnyFrame& frame) override
    {
      if (const auto* particles = frame.as<ParticleFrame>())
        record.add(*particles);
    }
    MotionRecord record;
  } sink(scene, most_bytes);
  Simulation simulation(scene);
  RunWatchers watchers;
  watchers.frames = {{&sink, {240.0, 0.0, 0.0, 0.0, 0.0}}};
  runToEnd(simulation, watchers);
  return sink.record.encoded(size);
}

TEST(MotionRecord, KeepsEveryFrameThatFits)
{
  const EncodedMotion motion = motionOf(smallRing(), PLENTY);
  EXPECT_EQ(motion.description["taken"], 241u);
  EXPECT_EQ(motion.description["every"], 1);
  EXPECT_EQ(motion.description["frames"], 241u);
  EXPECT_EQ(motion.description["tracks"], 4u);
  EXPECT_EQ(motion.description["states"], 4u * 241u);
}

TEST(MotionRecord, ThinsFramesToASize)
{
  for (const std::size_t size : {2500U, 1500U})
  {
    const EncodedMotion motion = motionOf(smallRing(), size);
    EXPECT_LE(motion.bytes.size(), size);
    EXPECT_GT(motion.bytes.size(), size / 3);
    const std::size_t every = motion.description["every"];
    EXPECT_EQ(motion.description["frames"], 240 / every + (240 % every == 0 ? 1 : 2)) << "and the last";
    EXPECT_EQ(motion.description["cut"], false);
  }
}

TEST(MotionRecord, EndsBeforeTheRunRatherThanToLeapBetweenFrames)
{
  for (const auto& [size, memory] : {std::pair<std::size_t, std::size_t>{300U, PLENTY}, {1000U, 200U}})
  {
    const EncodedMotion motion = motionOf(smallRing(), size, memory);
    EXPECT_LE(motion.bytes.size(), size);
    EXPECT_EQ(motion.description["every"], 8);
    EXPECT_LT(motion.description["frames"], 31);
    EXPECT_EQ(motion.description["cut"], true);
    EXPECT_EQ(motion.description["taken"], 241u);
  }
  EXPECT_EQ(motionOf(smallMixture(), 1).description["frames"], 2);
}

TEST(MotionRecord, CountsFramesWithoutDisksInItsMemory)
{
  for (const bool pair_collisions : {true, false})
  {
    SceneDefinition scene = smallMixture();
    scene.contact.pair_collisions = pair_collisions;
    MotionRecord record(scene, 4000);
    for (int k = 0; k < 100'000; ++k)
      record.add({k / 240.0, {}});
    EXPECT_LE(record.encoded(PLENTY).description["frames"], 1002u);
  }
}

TEST(MotionRecord, ThinsDisksThatDoNotSeeEachOther)
{
  SceneDefinition scene = smallRing();
  scene.contact.pair_collisions = false;
  scene.species[0].count = 60;
  const EncodedMotion motion = motionOf(scene, 2000);
  EXPECT_LE(motion.bytes.size(), 2000u);
  EXPECT_GT(motion.description["disk_every"], 1);
  EXPECT_GE(motion.description["frames"], MotionRecord::LEAST_RATE);
  EXPECT_EQ(motionOf(scene, 1).description["frames"], 2) << "where there is no room for a disk";
}

TEST(MotionRecord, TakesADiskThatComesBackForAnotherTrack)
{
  const SceneDefinition scene = smallMixture();
  MotionRecord record(scene, PLENTY);
  EXPECT_EQ(record.encoded(PLENTY).description["frames"], 0u);
  const DiskState disk{3, 1, 0.01, 0.02, 0.5, 0.1, -0.2, 30.0, 0.0, 0.0};
  for (const ParticleFrame& frame : {ParticleFrame{0.0, {disk}}, ParticleFrame{0.5, {}},
                                     ParticleFrame{1.0, {disk}}, ParticleFrame{1.5, {disk}}})
    record.add(frame);
  EXPECT_EQ(record.encoded(PLENTY).description["tracks"], 2);
}

RC_GTEST_PROP(MotionRecord, SurvivesImpossibleStates, ())
{
  const auto any = rc::gen::map(rc::gen::pair(rc::gen::inRange(-300, 300), rc::gen::inRange(-9, 10)),
                                [](const std::pair<int, int>& parts)
                                { return parts.second * std::pow(10.0, parts.first); });
  const SceneDefinition scene = smallMixture();
  MotionRecord record(scene, PLENTY);
  for (int k = 0; k < 3; ++k)
    record.add({static_cast<double>(k), {{1, 0, *any, *any, *any, *any, *any, *any, 0.0, 0.0}}});
  RC_ASSERT(record.encoded(PLENTY).description["frames"] == 3u);
}

}  // namespace
}  // namespace ratchet_sieve
