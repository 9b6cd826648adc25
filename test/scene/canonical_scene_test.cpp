// Scenes at random are written and read back in legal_scenes_test.cpp.
#include "ratchet_sieve/scene/canonical_scene.h"

#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ratchet_sieve/core/results.h"
#include "scene_texts.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition good()
{
  return sceneFromText(GOOD_SCENE, "s.yaml").definition;
}

/// Scenes that were recorded before a key was added keep their text, and so their hash: at its default the
/// key is not written.
TEST(CanonicalScene, OfAnOldSceneIsWhatItWasThen)
{
  EXPECT_EQ(
      canonicalYaml(good()),
      "base: {teeth: 20, tooth_width: 0.02, tooth_height: 0.006, asymmetry: 0.3, inclination: 0, amplitude: "
      "0.002, frequency: 23, phase: 0}\n"
      "boundary: periodic\n"
      "gravity: 9.81\n"
      "species:\n"
      "  - {name: \"A\", count: 10, share: 1, radius: 0.001, mass: 0.001, inertia_factor: 0.5, restitution: "
      "0.6, friction: 0.1, tangential_restitution: 0.4}\n"
      "  - {name: \"B\", count: 10, share: 1, radius: 0.002, mass: 0.002, inertia_factor: 0.5, restitution: "
      "0.6, friction: 0.1, tangential_restitution: 0.4}\n"
      "pairs: []\n"
      "contact: {pair_collisions: true, min_rebound_speed: 0.05, contact_duration: 0, on_collapse: stop, "
      "collapse_events: 1000000}\n"
      "pour: {drop_height: 0.02, speed: 0}\n"
      "feed: {rate: 0}\n"
      "initial: []\n"
      "duration: 10\n"
      "settle: 0\n"
      "seed: 1\n");
  EXPECT_EQ(sceneHash(good()), "0cacddcdb5d089c8");
}

/// What the engine in a browser gets of a scene.
SceneDefinition throughBytes(SceneDefinition scene)
{
  StateArchive saved;
  scene.archive(saved);
  const std::string bytes = saved.takeBytes();
  SceneDefinition restored;
  StateArchive archive(bytes);
  restored.archive(archive);
  archive.requireEnd();
  return restored;
}

TEST(CanonicalScene, AndBytesHaveEveryKeyThatIsSet)
{
  const SceneDefinition scene = sceneFromText(EVERY_KEY, "s.yaml").definition;
  EXPECT_EQ(canonicalYaml(scene), EVERY_KEY);
  EXPECT_EQ(canonicalYaml(throughBytes(scene)), EVERY_KEY);
}

/// In place of the keys of a sawtooth, so that it can be read back.
TEST(CanonicalScene, HasAProfileOrASawtooth)
{
  SceneDefinition scene = good();
  scene.base.profile = {{0.0, 0.0}, {0.006, 0.006}, {0.02, 0.0}};
  const std::string yaml = canonicalYaml(scene);
  EXPECT_NE(yaml.find("profile: [[0, 0], [0.006, 0.006], [0.02, 0]]"), std::string::npos) << yaml;
  EXPECT_EQ(yaml.find("tooth_"), std::string::npos);
  EXPECT_EQ(yaml.find("asymmetry"), std::string::npos);
  EXPECT_EQ(canonicalYaml(sceneFromText(yaml, "s.yaml").definition), yaml);
  EXPECT_EQ(canonicalYaml(throughBytes(scene)), yaml);
  EXPECT_NE(sceneHash(scene), sceneHash(good()));
}

void expectSameBits(double amplitude, double phase)
{
  SceneDefinition scene = good();
  scene.base.amplitude = amplitude;
  scene.base.phase = phase;
  const BaseDefinition base = sceneFromText(canonicalYaml(scene), "s.yaml").definition.base;
  EXPECT_EQ(std::memcmp(&base.amplitude, &amplitude, sizeof amplitude), 0) << amplitude;
  EXPECT_EQ(std::memcmp(&base.phase, &phase, sizeof phase), 0) << phase;
}

RC_GTEST_PROP(CanonicalScene, HoldsNumbersThatReadBackBitForBit, (double a, double b))
{
  expectSameBits(std::abs(std::remainder(a, 1.0)), std::remainder(b, 1e6));
}

TEST(CanonicalScene, KeepsTheSmallestNumbers)
{
  expectSameBits(4.9406564584124654e-324, 0.1 + 0.2);
}

/// Or 0.0 and -0.0 would be two settings, with two hashes.
TEST(CanonicalScene, HasOneZero)
{
  SceneDefinition minus = good();
  minus.base.phase = -0.0;
  EXPECT_EQ(canonicalYaml(minus), canonicalYaml(good()));
  for (const std::string key :
       {"base.inclination=", "base.horizontal_phase=", "base.harmonics=[{multiple: 2, phase: ", "pour.speed=",
        "contact.min_rebound_speed=", "settle=", "feed.rate=", "base.profile=[[0, 0], [0.01, 0.01], [0.02, ",
        "initial=[{species: A, x: 0.01, y: 0.1, vx: "})
    for (const std::string zero : {"-0.0", "-0", "-0e5"})
    {
      const std::string end = std::count(key.begin(), key.end(), '{') > 0   ? "}]"
                              : std::count(key.begin(), key.end(), '[') > 0 ? "]]"
                                                                            : "";
      const auto with = [&](const std::string& value)
      { return sceneFromText(GOOD_SCENE, "s.yaml", {key + value + end}).definition; };
      EXPECT_EQ(canonicalYaml(with(zero)), canonicalYaml(with("0.0"))) << key << zero;
      EXPECT_EQ(runHash(with(zero)), runHash(with("0"))) << key << zero;
    }
}

TEST(CanonicalScene, OfPlacedDisksReadsBackWithoutAWarning)
{
  const std::string text = goodSceneWith("pairs: []", "initial: [{species: A, x: 0.01, y: 0.1}]");
  const Scene scene = sceneFromText(text, "s.yaml");
  EXPECT_EQ(scene.warnings.size(), 2u);
  EXPECT_TRUE(sceneFromText(canonicalYaml(scene.definition), "canonical").warnings.empty());
}

TEST(SceneHash, IsThatOfTheMotionAlone)
{
  SceneDefinition run = good();
  run.seed = 99;
  run.duration = 55.0;
  run.settle = 5.0;
  run.accuracy.mean_vx = 0.1;
  EXPECT_EQ(sceneHash(run), sceneHash(good()));
  SceneDefinition motion = good();
  motion.base.frequency = std::nextafter(motion.base.frequency, 99.0);
  EXPECT_NE(sceneHash(motion), sceneHash(good()));
}

TEST(RunHash, ChangesWithEveryKey)
{
  SceneDefinition other = good();
  std::set<std::string> hashes = {runHash(other)};
  for (const auto change : {+[](SceneDefinition& scene) { scene.seed = 99; },
                            +[](SceneDefinition& scene) { scene.duration += 1.0; },
                            +[](SceneDefinition& scene) { scene.settle += 1.0; },
                            +[](SceneDefinition& scene) { scene.gravity = 9.0; }})
  {
    change(other);
    EXPECT_TRUE(hashes.insert(runHash(other)).second);
  }
}

TEST(SceneHash, IsTheSameForADensityAndItsCounts)
{
  const char* const counts = "species: [{name: A, count: 200, radius: 0.001, mass: 0.01}]\n";
  const char* const density = "species: [{name: A, radius: 0.001, mass: 0.01}]\ndensity: 1.0\n";
  EXPECT_EQ(sceneHash(sceneFromText(counts, "c").definition),
            sceneHash(sceneFromText(density, "d").definition));
}

/// Without spread they are not written.
TEST(SceneHash, IsNoOtherForSizesThatAreAllEqual)
{
  const std::string none =
      goodSceneWith("mass: 0.001", "mass: 0.001, size: {distribution: normal, spread: 0}");
  EXPECT_EQ(sceneHash(sceneFromText(none, "s.yaml").definition), sceneHash(good()));
}

}  // namespace
}  // namespace ratchet_sieve
