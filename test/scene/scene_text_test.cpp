#include "ratchet_sieve/scene/scene_text.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
constexpr const char* NO_SIMD =
    ", no SIMD (only for independent disks without contact times on a periodic sawtooth with a vertical sine "
    "drive)";

SceneDefinition fiveDisks(bool pairs)
{
  SceneDefinition scene;
  scene.species = {SpeciesDefinition()};
  scene.species[0].count = 5;
  scene.contact.pair_collisions = pairs;
  return scene;
}

TEST(SceneText, SaysWhatThePlanComputes)
{
  const std::string no_band =
      ", no contact times (contact_duration is 0), no base search above the base's reach";
  EXPECT_EQ(planText(planOf(fiveDisks(true))), "pairs, spin, drive" + no_band + NO_SIMD);
  EXPECT_EQ(planText(planOf(fiveDisks(false))),
            "no pairs (disks do not collide with each other), spin, drive" + no_band + ", SIMD");
  SceneDefinition still = fiveDisks(false);
  still.species[0].contact.friction = 0.0;
  still.base.amplitude = 0.0;
  still.contact.contact_duration = 1e-4;
  EXPECT_EQ(planText(planOf(still)),
            "no pairs (disks do not collide with each other), no spin (no friction turns a disk), no drive "
            "(the base "
            "stands still), contact times, no base search above the base's reach" +
                std::string(NO_SIMD));
  SceneDefinition stepped = fiveDisks(true);
  stepped.accuracy.method = Method::STEPS;
  stepped.base.harmonics = {{2, 1e-4, 0.0, 0.0, 0.0}};
  const std::string text = planText(planOf(stepped));
  EXPECT_EQ(text.find("pairs, by steps (contacts that begin and end within a step are missed), "), 0u)
      << text;
  EXPECT_NE(text.find("drive with a horizontal part or harmonics"), std::string::npos) << text;
}

TEST(SceneText, SaysHowLargeTheSceneIs)
{
  SceneDefinition scene = fiveDisks(true);
  scene.species[0].count = 262;
  EXPECT_EQ(sizeText(scene), "262 disks, at rest a layer of about 0.00251 m, about 1 MB of memory");
  scene.species[0].count = 1;
  scene.contact.pair_collisions = false;
  scene.feed.rate = 2.5;
  EXPECT_EQ(sizeText(scene), "1 disk, fed at 2.5/s, about 1 MB of memory");
}

}  // namespace
}  // namespace ratchet_sieve
