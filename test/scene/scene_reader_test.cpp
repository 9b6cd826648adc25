#include <gtest/gtest.h>

#include "ratchet_sieve/scene/canonical_scene.h"
#include "scene_texts.h"

namespace ratchet_sieve
{
namespace
{

Scene read(const std::string& text)
{
  return sceneFromText(text, "s.yaml");
}

const char* const ONE_SPECIES = "species: [{name: A, count: 3, radius: 0.001, mass: 0.002}]\n";

/// Defaults, and the other keys, are in canonical_scene_test.cpp.
TEST(SceneReader, TakesEveryKey)
{
  const SceneDefinition scene = read(EVERY_KEY).definition;
  EXPECT_EQ(scene.base.teeth, 3);
  EXPECT_EQ(scene.base.asymmetry, 0.7);
  EXPECT_EQ(scene.base.inclination, -0.2);
  EXPECT_EQ(scene.base.amplitude, 0.001);
  EXPECT_EQ(scene.base.phase, 1.5);
  EXPECT_EQ(scene.base.wall_height, 0.3);
  EXPECT_EQ(scene.base.drive_frame, DriveFrame::BASE);
  EXPECT_EQ(scene.base.horizontal_amplitude, -0.002);
  EXPECT_EQ(scene.base.horizontal_phase, 0.5);
  ASSERT_EQ(scene.base.harmonics.size(), 2u);
  EXPECT_EQ(scene.base.harmonics[0].multiple, 2);
  EXPECT_EQ(scene.base.harmonics[0].amplitude, -0.0001);
  EXPECT_EQ(scene.base.harmonics[0].phase, 1.0);
  EXPECT_EQ(scene.base.harmonics[1].horizontal_amplitude, 0.0002);
  EXPECT_EQ(scene.base.harmonics[1].horizontal_phase, -1.0);
  EXPECT_EQ(scene.boundary, Boundary::WALLED);
  EXPECT_EQ(scene.gravity, 1.62);
  EXPECT_EQ(scene.species[0].share, 2.0);
  EXPECT_EQ(scene.species[0].contact.friction, 0.3);
  EXPECT_EQ(scene.species[0].contact.tangential_restitution, -0.5);
  EXPECT_EQ(scene.species[0].inertia_factor, 0.4);
  ASSERT_EQ(scene.pairs.size(), 1u);
  EXPECT_EQ(scene.pairs[0].first, 1u);
  EXPECT_EQ(scene.pairs[0].second, 0u);
  EXPECT_EQ(scene.pairs[0].contact.friction, 0.2);
  EXPECT_FALSE(scene.contact.pair_collisions);
  EXPECT_EQ(scene.contact.contact_duration, 0.0001);
  EXPECT_EQ(scene.pour.speed, 0.5);
  EXPECT_EQ(scene.pour.stretch.from, 0.001);
  EXPECT_EQ(scene.pour.stretch.to, 0.002);
  EXPECT_EQ(scene.feed.rate, 3.5);
  EXPECT_EQ(scene.feed.stretch.from, 0.01);
  EXPECT_EQ(scene.feed.stretch.to, 0.03);
  EXPECT_EQ(scene.observe, (std::vector<std::string>{"residence_times", "mass_flow"}));
  EXPECT_EQ(scene.height_profile.slice, 0.0005);
  EXPECT_EQ(scene.height_profile.phases, 4);
  EXPECT_EQ(scene.settle, 2.0);
  EXPECT_EQ(scene.seed, 18446744073709551615u);
}

TEST(SceneReader, TakesTheLegalExtremes)
{
  for (const char* base : {"asymmetry: 0", "asymmetry: 1", "tooth_height: 0", "amplitude: 0", "frequency: 0",
                           "inclination: 1.5", "inclination: -1.5", "teeth: 1"})
    EXPECT_EQ(refusalOf(goodSceneWith("teeth: 20", base)), "") << base;
  for (const char* species :
       {"restitution: 0", "restitution: 1", "tangential_restitution: -1", "tangential_restitution: 1",
        "friction: 0", "friction: 1e6", "inertia_factor: 1"})
    EXPECT_EQ(refusalOf(goodSceneWith("mass: 0.001", "mass: 0.001, " + std::string(species))), "") << species;
  for (const char* root : {"gravity: 0", "contact: {min_rebound_speed: 0}", "initial: []"})
    EXPECT_EQ(refusalOf(ONE_SPECIES + std::string(root)), "") << root;
  EXPECT_EQ(refusalOf(goodSceneWith("count: 10", "count: 0")), "");
  EXPECT_EQ(refusalOf(goodSceneWith("settle: 0.0", "settle: 10.0")), "");
}

TEST(SceneReader, GivesAPairTheMeanOfItsSpeciesWhereItSaysNothing)
{
  const SceneDefinition scene = read(R"(
species:
  - {name: A, count: 1, radius: 0.001, mass: 0.001, friction: 0.1, restitution: 0.4}
  - {name: B, count: 1, radius: 0.001, mass: 0.001, friction: 0.3, restitution: 0.8}
pairs: [{species: [A, B], restitution: 0.25}]
)")
                                    .definition;
  EXPECT_EQ(scene.pairs[0].contact.restitution, 0.25);
  EXPECT_DOUBLE_EQ(scene.pairs[0].contact.friction, 0.2);
}

TEST(SceneReader, SplitsADensityByShares)
{
  struct
  {
    const char *a, *b;
    std::vector<int> counts;
    const char* density;
  } const cases[] = {
      // The mixture of Fig. 8: W = 0.4 m, diameters of 2 mm and 4 mm: 1.572 m / 6 mm = 262 of each.
      {"", "", {262, 262}, "3.93"},
      // S = 0.4 m; three A of 2 mm to one B of 4 mm: 0.4 / 0.010 = 40 times that.
      {", share: 3", ", share: 1", {120, 40}, "1.0"},
      // 3 kg of A to 1 kg of B: 3 / 0.01 to 1 / 0.001 disks, 3 to 10; S = 0.4 m, 46 mm for 13 disks.
      {", share: 3, share_by: mass", ", share: 1, share_by: mass", {26, 87}, "1.0"},
      // By the expected diameter: 4 * 0.4 m / 0.004 m.
      {", size: {distribution: table, radii: [0.001, 0.003], weights: [0, 1]}", ", share: 0", {400, 0}, "4"}};
  for (const auto& [a, b, counts, density] : cases)
  {
    const Scene scene =
        read("species:\n  - {name: A, radius: 0.001, mass: 0.010" + std::string(a) +
             "}\n  - {name: B, radius: 0.002, mass: 0.001" + b + "}\ndensity: " + density + "\n");
    EXPECT_EQ(scene.definition.species[0].count, counts[0]) << a;
    EXPECT_EQ(scene.definition.species[1].count, counts[1]) << b;
    EXPECT_TRUE(scene.warnings.empty());
  }
}

/// By the mean mass of a disk: for a uniform distribution of r (1 - s) to r (1 + s) m (1 + s^2).
TEST(SceneReader, TurnsSharesByMassOfSizesIntoSharesByNumber)
{
  const Scene scene = read(R"(
species:
  - {name: A, share: 1, share_by: mass, radius: 0.001, mass: 0.010}
  - {name: B, share: 1, share_by: mass, radius: 0.001, mass: 0.010, size: {distribution: uniform, spread: 0.5}}
  - {name: C, share: 0, share_by: mass, radius: 0.001, mass: 1e-18}
feed: {rate: 10}
)");
  EXPECT_EQ(scene.definition.species[0].share, 1.0);
  EXPECT_NEAR(scene.definition.species[1].share, 1.0 / 1.25, 1e-5);
  EXPECT_EQ(scene.definition.species[2].share, 0.0);
}

/// Also where a disk has the smallest mass that is allowed: its text is read back.
TEST(SceneReader, WritesSharesByMassAsThoseByNumber)
{
  const Scene scene = read(R"(
species:
  - {name: A, share: 1e9, share_by: mass, radius: 0.001, mass: 1e-18}
  - {name: B, share: 1e-3, share_by: mass, radius: 0.002, mass: 1e6}
feed: {rate: 10}
)");
  const std::string yaml = canonicalYaml(scene.definition);
  EXPECT_EQ(yaml.find("share_by"), std::string::npos);
  EXPECT_EQ(canonicalYaml(read(yaml).definition), yaml);
}

TEST(SceneReader, TakesTheNumberOfTeethFromALength)
{
  const std::string species = "species: [{name: A, count: 1, radius: 0.001, mass: 0.01}]\n";
  const Scene exact = read("base: {length: 0.6, tooth_width: 0.025}\n" + species);
  EXPECT_EQ(exact.definition.base.teeth, 24);
  EXPECT_TRUE(exact.warnings.empty());
  const Scene counted = read("base: {teeth: 24, tooth_width: 0.025}\n" + species);
  EXPECT_EQ(sceneHash(exact.definition), sceneHash(counted.definition));
  EXPECT_EQ(canonicalYaml(exact.definition), canonicalYaml(counted.definition));

  const Scene rounded = read("base: {length: 0.6, tooth_width: 0.022}\n" + species);
  EXPECT_EQ(rounded.definition.base.teeth, 27);
  EXPECT_EQ(rounded.warnings,
            std::vector<std::string>{
                "base.length = 0.6 m is rounded to 27 teeth of 0.022 m: 0.594 m [rounded-length]"});
}

TEST(SceneReader, WarnsOfACountBesideADensity)
{
  const Scene scene = read(R"(
species:
  - {name: A, count: 7, radius: 0.001, mass: 0.010}
density: 1.0
)");
  EXPECT_EQ(scene.definition.species[0].count, 200);
  EXPECT_EQ(scene.warnings, std::vector<std::string>{
                                "species.0.count is ignored because a density is given [ignored-count]"});
}

TEST(SceneReader, PoursNothingWhereInitialPlacesTheDisks)
{
  const Scene scene = read(R"(
species:
  - {name: A, count: 7, radius: 0.001, mass: 0.010}
  - {name: B, radius: 0.001, mass: 0.010}
initial:
  - {species: B, x: 0.1, y: 0.05, vx: -1, vy: 2, spin: 3}
  - {species: A, x: 0.2, y: 0.05}
)");
  EXPECT_EQ(scene.definition.species[0].count, 0);
  EXPECT_EQ(scene.warnings,
            std::vector<std::string>{
                "species.0.count is ignored because initial places the disks [ignored-count]"});
  ASSERT_EQ(scene.definition.initial.size(), 2u);
  EXPECT_EQ(scene.definition.initial[0].species, 1u);
  EXPECT_EQ(scene.definition.initial[0].vx, -1.0);
  EXPECT_EQ(scene.definition.initial[0].spin, 3.0);
  EXPECT_EQ(scene.definition.initial[1].vy, 0.0);
}

TEST(SceneReader, NeedsNoCountWhereThereIsAFeed)
{
  const Scene scene = read("species: [{name: A, radius: 0.001, mass: 0.002}]\nfeed: {rate: 2, from: 0.01}\n");
  EXPECT_EQ(scene.definition.species[0].count, 0);
  EXPECT_DOUBLE_EQ(scene.definition.feed.stretch.length(0.4), 0.39);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneReader, TakesTheMassFromADensity)
{
  // A ball of steel of 2 mm: 4.18879e-9 m^3 times 7800 kg/m^3.
  const Scene scene = read("species: [{name: A, count: 1, radius: 0.001, density: 7800}]\n");
  EXPECT_NEAR(scene.definition.species[0].mass, 3.26726e-5, 1e-10);
}

TEST(SceneReader, TakesATreeThatNoTextStandsBehind)
{
  YAML::Node species;
  species["name"] = "A";
  species["count"] = 4;
  species["radius"] = 0.001;
  species["mass"] = 0.25;
  YAML::Node root;
  root["species"].push_back(species);
  root["contact"]["pair_collisions"] = false;
  const Scene scene = sceneFromYaml(root, "parameter /sieve/scene");
  EXPECT_EQ(scene.definition.species[0].mass, 0.25);
  EXPECT_FALSE(scene.definition.contact.pair_collisions);

  root["gravity"] = "heavy";
  EXPECT_EQ(refusalBy([&] { sceneFromYaml(root, "parameter /sieve/scene"); }),
            "parameter /sieve/scene: gravity = heavy: must be a number from 0 to 10000 m/s^2");
}

}  // namespace
}  // namespace ratchet_sieve
