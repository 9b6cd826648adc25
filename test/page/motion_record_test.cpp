#include "motion_record.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "deflate.h"
#include "motion_reading.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "recording/collecting_sink.h"
#include "recording/small_scenes.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::size_t PLENTY = 10'000'000;

/// Frames of a run, 240 a second.
std::vector<ParticleFrame> framesOfRun(const SceneDefinition& scene)
{
  struct Frames : FrameSink
  {
    void take(const AnyFrame& frame) override
    {
      if (const auto* particles = frame.as<ParticleFrame>())
        frames.push_back(*particles);
    }
    std::vector<ParticleFrame> frames;
  } sink;
  Simulation simulation(scene);
  RunWatchers watchers;
  watchers.frames = {{&sink, {240.0, 0.0, 0.0, 0.0, 0.0}}};
  runToEnd(simulation, watchers);
  return sink.frames;
}

MotionRecord recordOf(const SceneDefinition& scene, const std::vector<ParticleFrame>& frames,
                      std::size_t most_bytes = PLENTY)
{
  MotionRecord record(scene, most_bytes);
  for (const ParticleFrame& frame : frames)
    record.take(frame);
  return record;
}

/// Compares every disk of the encoded frames with the frame of that time.
void expectNear(const EncodedMotion& encoded, const std::vector<ParticleFrame>& frames,
                const SceneDefinition& scene)
{
  const double position = 0.51 * encoded.description["position_unit"].get<double>();
  const double velocity = 0.51 * encoded.description["velocity_unit"].get<double>();
  const std::uint32_t every = encoded.description["disk_every"];
  for (const ParticleFrame& read : framesOf(encoded))
  {
    const auto frame = std::find_if(frames.begin(), frames.end(),
                                    [&](const ParticleFrame& each) { return each.time == read.time; });
    ASSERT_NE(frame, frames.end());
    std::map<std::uint32_t, DiskState> disks;
    for (const DiskState& disk : frame->disks)
      if (disk.id % every == 0)
        disks[disk.id] = disk;
    ASSERT_EQ(read.disks.size(), disks.size());
    for (const DiskState& disk : read.disks)
    {
      ASSERT_EQ(disks.count(disk.id), 1u);
      const DiskState& recorded = disks[disk.id];
      EXPECT_EQ(disk.species, recorded.species);
      EXPECT_NEAR(disk.radius, radiusOf(recorded, scene.species), 1e-6);
      EXPECT_NEAR(disk.x, recorded.x, position);
      EXPECT_NEAR(disk.y, recorded.y, position);
      EXPECT_NEAR(disk.vx, recorded.vx, velocity);
      EXPECT_NEAR(disk.vy, recorded.vy, velocity);
      EXPECT_NEAR(disk.spin, recorded.spin, 3.01);
      EXPECT_LT(std::abs(std::remainder(disk.angle - recorded.angle, 6.283185307179586)), 0.0123);
    }
  }
}

TEST(MotionRecord, KeepsEveryFrameThatFits)
{
  for (SceneDefinition scene : {smallMixture(), smallRing()})
  {
    scene.species[1].size.spread = 0.3;
    const std::vector<ParticleFrame> frames = framesOfRun(scene);
    const EncodedMotion encoded = recordOf(scene, frames).encoded(PLENTY);
    EXPECT_EQ(framesOf(encoded).size(), frames.size());
    EXPECT_EQ(encoded.description["every"], 1);
    expectNear(encoded, frames, scene);
  }
}

TEST(MotionRecord, ThinsFramesToASize)
{
  const SceneDefinition scene = smallRing();
  const std::vector<ParticleFrame> frames = framesOfRun(scene);
  const MotionRecord record = recordOf(scene, frames);
  for (const std::size_t size : {2500U, 1500U, 800U})
  {
    const EncodedMotion encoded = record.encoded(size);
    EXPECT_LE(encoded.bytes.size(), size);
    EXPECT_GT(encoded.bytes.size(), size / 3);
    const std::size_t every = encoded.description["every"];
    EXPECT_GT(every, 1u);
    EXPECT_EQ(encoded.description["taken"], frames.size());
    const std::vector<ParticleFrame> read = framesOf(encoded);
    for (std::size_t k = 0; k + 1 < read.size(); ++k)
      EXPECT_EQ(read[k].time, frames[every * k].time);
    EXPECT_EQ(read.back().time, frames.back().time);
    expectNear(encoded, frames, scene);
  }
}

TEST(MotionRecord, ThinsWhatItTakesToAMemory)
{
  const SceneDefinition scene = smallRing();
  const std::vector<ParticleFrame> frames = framesOfRun(scene);
  const EncodedMotion encoded = recordOf(scene, frames, 1000).encoded(1000);
  EXPECT_LE(encoded.bytes.size(), 1000u);
  EXPECT_EQ(framesOf(encoded).back().time, frames.back().time);
  expectNear(encoded, frames, scene);
}

TEST(MotionRecord, ThinsDisksThatDoNotSeeEachOther)
{
  SceneDefinition scene = smallRing();
  scene.contact.pair_collisions = false;
  scene.species[0].count = 60;
  const std::vector<ParticleFrame> frames = framesOfRun(scene);
  const EncodedMotion encoded = recordOf(scene, frames).encoded(2000);
  EXPECT_LE(encoded.bytes.size(), 2000u);
  EXPECT_GT(encoded.description["disk_every"], 1);
  EXPECT_GE(framesOf(encoded).size(), static_cast<std::size_t>(MotionRecord::LEAST_RATE));
  expectNear(encoded, frames, scene);
}

TEST(MotionRecord, KeepsTheFirstAndTheLastFrameInAnySize)
{
  const SceneDefinition scene = smallMixture();
  const std::vector<ParticleFrame> frames = framesOfRun(scene);
  const EncodedMotion encoded = recordOf(scene, frames).encoded(1);
  EXPECT_EQ(framesOf(encoded).size(), 2u);
  expectNear(encoded, frames, scene);
}

TEST(MotionRecord, TakesADiskThatComesBackForAnotherTrack)
{
  const SceneDefinition scene = smallMixture();
  const DiskState disk{3, 1, 0.01, 0.02, 0.5, 0.1, -0.2, 30.0, 0.0, 0.0};
  const std::vector<ParticleFrame> frames = {{0.0, {disk}}, {0.5, {}}, {1.0, {disk}}, {1.5, {disk}}};
  const EncodedMotion encoded = recordOf(scene, frames).encoded(PLENTY);
  EXPECT_EQ(encoded.description["tracks"], 2);
  expectNear(encoded, frames, scene);
}

TEST(MotionRecord, TakesFramesWithoutDisks)
{
  const SceneDefinition scene = smallMixture();
  EXPECT_EQ(framesOf(recordOf(scene, {}).encoded(PLENTY)).size(), 0u);
  EXPECT_EQ(framesOf(recordOf(scene, {{0.0, {}}, {1.0, {}}}).encoded(PLENTY)).size(), 2u);
}

RC_GTEST_PROP(BytePlanes, AreReadBack, (const std::vector<std::int32_t>& numbers))
{
  PlaneReader reader(inflated(deflated(bytePlanes(numbers))));
  RC_ASSERT(reader.next(numbers.size()) == numbers);
  RC_ASSERT(reader.atEnd());
}

RC_GTEST_PROP(MotionRecord, SurvivesImpossibleStates, ())
{
  const auto any = rc::gen::map(rc::gen::pair(rc::gen::inRange(-300, 300), rc::gen::inRange(-9, 10)),
                                [](const std::pair<int, int>& parts)
                                { return parts.second * std::pow(10.0, parts.first); });
  std::vector<ParticleFrame> frames;
  for (int k = 0; k < 3; ++k)
    frames.push_back({static_cast<double>(k), {{1, 0, *any, *any, *any, *any, *any, *any, 0.0, 0.0}}});
  const SceneDefinition scene = smallMixture();
  RC_ASSERT(framesOf(recordOf(scene, frames).encoded(PLENTY)).size() == 3u);
}

}  // namespace
}  // namespace ratchet_sieve
