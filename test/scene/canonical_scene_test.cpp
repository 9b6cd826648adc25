#include "ratchet_sieve/scene/canonical_scene.h"

#include <cstring>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ratchet_sieve/core/observation.h"
#include "scene_texts.h"

namespace ratchet_sieve
{
namespace
{

/// Whether two structs of doubles, or two doubles, have the same bits.
bool sameBits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same(const ContactCoefficients& a, const ContactCoefficients& b)
{
  return sameBits(a.restitution, b.restitution) && sameBits(a.friction, b.friction) &&
         sameBits(a.tangential_restitution, b.tangential_restitution);
}

bool same(const HarmonicDefinition& a, const HarmonicDefinition& b)
{
  return a.multiple == b.multiple && sameBits(a.amplitude, b.amplitude) && sameBits(a.phase, b.phase) &&
         sameBits(a.horizontal_amplitude, b.horizontal_amplitude) &&
         sameBits(a.horizontal_phase, b.horizontal_phase);
}

template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b);

bool same(const OutlineCorner& a, const OutlineCorner& b)
{
  return sameBits(a.s, b.s) && sameBits(a.n, b.n);
}

bool same(const BaseDefinition& a, const BaseDefinition& b)
{
  const bool sawtooth = a.profile.empty();
  return a.teeth == b.teeth && same(a.profile, b.profile) &&
         (!sawtooth || sameBits(a.tooth_width, b.tooth_width)) &&
         (!sawtooth || sameBits(a.tooth_height, b.tooth_height)) &&
         (!sawtooth || sameBits(a.asymmetry, b.asymmetry)) && sameBits(a.inclination, b.inclination) &&
         sameBits(a.amplitude, b.amplitude) && sameBits(a.frequency, b.frequency) &&
         sameBits(a.phase, b.phase) && sameBits(a.wall_height, b.wall_height) &&
         sameBits(a.horizontal_amplitude, b.horizontal_amplitude) &&
         sameBits(a.horizontal_phase, b.horizontal_phase) && same(a.harmonics, b.harmonics) &&
         a.drive_frame == b.drive_frame;
}

bool same(const Stretch& a, const Stretch& b)
{
  return sameBits(a.from, b.from) && sameBits(a.to, b.to);
}

bool same(const SizeDefinition& a, const SizeDefinition& b)
{
  return a.distribution == b.distribution && sameBits(a.spread, b.spread) &&
         sameBits(a.mass_exponent, b.mass_exponent) && a.radii == b.radii && a.weights == b.weights &&
         a.by == b.by;
}

bool same(const SpeciesDefinition& a, const SpeciesDefinition& b)
{
  return a.name == b.name && a.count == b.count && sameBits(a.share, b.share) &&
         sameBits(a.radius, b.radius) && sameBits(a.mass, b.mass) && same(a.contact, b.contact) &&
         sameBits(a.inertia_factor, b.inertia_factor) && same(a.size, b.size);
}

bool same(const PairDefinition& a, const PairDefinition& b)
{
  return a.first == b.first && a.second == b.second && same(a.contact, b.contact);
}

bool same(const InitialDisk& a, const InitialDisk& b)
{
  return a.species == b.species && sameBits(a.x, b.x) && sameBits(a.y, b.y) && sameBits(a.vx, b.vx) &&
         sameBits(a.vy, b.vy) && sameBits(a.spin, b.spin);
}

template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}

bool same(const SceneDefinition& a, const SceneDefinition& b)
{
  return same(a.base, b.base) && a.boundary == b.boundary && sameBits(a.gravity, b.gravity) &&
         same(a.species, b.species) && same(a.pairs, b.pairs) &&
         a.contact.pair_collisions == b.contact.pair_collisions &&
         sameBits(a.contact.min_rebound_speed, b.contact.min_rebound_speed) &&
         sameBits(a.contact.contact_duration, b.contact.contact_duration) &&
         sameBits(a.contact.restitution_speed, b.contact.restitution_speed) &&
         sameBits(a.contact.restitution_exponent, b.contact.restitution_exponent) &&
         sameBits(a.pour.drop_height, b.pour.drop_height) && sameBits(a.pour.speed, b.pour.speed) &&
         sameBits(a.feed.rate, b.feed.rate) && a.feed.even == b.feed.even &&
         same(a.pour.stretch, b.pour.stretch) && same(a.feed.stretch, b.feed.stretch) &&
         same(a.initial, b.initial) && a.observe == b.observe &&
         sameBits(a.height_profile.slice, b.height_profile.slice) &&
         a.height_profile.phases == b.height_profile.phases && sameBits(a.duration, b.duration) &&
         sameBits(a.settle, b.settle) && a.seed == b.seed;
}

/// Any double of an interval, with all its digits.
double number(double lowest, double highest)
{
  const auto steps = *rc::gen::inRange<std::uint64_t>(0, (1ull << 53) + 1);
  const double fraction = static_cast<double>(steps) / static_cast<double>(1ull << 53);
  return std::min(highest, lowest + fraction * (highest - lowest));
}

ContactCoefficients coefficients()
{
  return {number(0.0, 1.0), number(0.0, 10.0), number(-1.0, 1.0)};
}

std::vector<SpeciesDefinition> someSpecies(bool counted)
{
  const std::string names[] = {"A", "b-2", "true", "1e3", "null", "~"};
  std::vector<SpeciesDefinition> all;
  const int size = *rc::gen::inRange(1, 6);
  for (int i = 0; i < size; ++i)
  {
    SpeciesDefinition species;
    species.name = names[i];
    species.count = counted ? *rc::gen::inRange(0, 1000) : 0;
    species.share = number(0.001, 5.0);
    // Large enough for the positions of the widest base and its walls, a hundred and a thousand metres.
    species.radius = number(5e-3, 1e-2);
    species.mass = number(1e-6, 1.0);
    species.contact = coefficients();
    species.inertia_factor = number(1e-3, 1.0);
    all.push_back(species);
  }
  return all;
}

std::vector<InitialDisk> someDisks(std::size_t species)
{
  std::vector<InitialDisk> disks(*rc::gen::inRange<std::size_t>(1, 5));
  for (InitialDisk& disk : disks)
    disk = {*rc::gen::inRange<std::size_t>(0, species),
            number(-1.0, 1.0),
            number(-1.0, 1.0),
            number(-1.0, 1.0),
            number(-1.0, 1.0),
            number(-99.0, 99.0)};
  return disks;
}

Stretch someStretch(double width)
{
  const double to = number(0.0, width);
  return {*rc::gen::arbitrary<bool>() ? number(0.0, to) : 0.0,
          *rc::gen::arbitrary<bool>() ? to : Stretch().to};
}

SceneDefinition anyScene()
{
  SceneDefinition scene;
  scene.base = {*rc::gen::inRange(1, 100),
                number(0.1, 1.0),
                number(0.0, 1.0),
                number(0.0, 1.0),
                number(-1.5, 1.5),
                number(0.0, 0.1),
                number(0.0, 99.0),
                number(-9.0, 9.0),
                0.0,
                0.0,
                0.0,
                {},
                *rc::gen::element(DriveFrame::WORLD, DriveFrame::BASE),
                {}};
  if (*rc::gen::inRange(0, 3) == 0)
    scene.base.profile = {{0.0, 0.0},
                          {number(0.01, 0.1), number(-0.1, 0.5)},
                          {number(0.1, 0.5), number(0.0, 0.1)},
                          {number(0.5, 1.0), 0.0}};
  scene.base.wall_height = *rc::gen::arbitrary<bool>() ? number(0.1, 1.0) : 0.0;
  if (*rc::gen::arbitrary<bool>())
  {
    scene.base.horizontal_amplitude = number(-0.1, 0.1);
    scene.base.horizontal_phase = number(-9.0, 9.0);
    scene.base.harmonics.resize(*rc::gen::inRange<std::size_t>(0, 4));
    for (HarmonicDefinition& harmonic : scene.base.harmonics)
      harmonic = {*rc::gen::inRange(2, 101), number(-0.1, 0.1), number(-9.0, 9.0), number(-0.1, 0.1),
                  number(-9.0, 9.0)};
  }
  scene.boundary = *rc::gen::element(Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED);
  scene.gravity = number(0.0, 20.0);
  const bool placed = *rc::gen::arbitrary<bool>();
  scene.species = someSpecies(!placed);
  if (placed)
    scene.initial = someDisks(scene.species.size());
  if (scene.species.size() > 1 && *rc::gen::arbitrary<bool>())
    scene.pairs.push_back({scene.species.size() - 1, 0, coefficients()});
  scene.contact.pair_collisions = *rc::gen::arbitrary<bool>();
  scene.contact.min_rebound_speed = number(0.0, 1.0);
  scene.contact.contact_duration = number(0.0, 1e-3);
  if (*rc::gen::arbitrary<bool>())
  {
    scene.contact.restitution_speed = number(0.0, 10.0);
    scene.contact.restitution_exponent = number(0.0, 10.0);
  }
  scene.pour = {number(0.0, 1.0), number(0.0, 1.0), someStretch(scene.base.width())};
  scene.feed.rate = number(0.0, 100.0);
  scene.feed.even = *rc::gen::arbitrary<bool>();
  scene.feed.stretch = someStretch(scene.base.width());
  if (*rc::gen::arbitrary<bool>())
  {
    scene.observe = observableNames();
    scene.height_profile = {number(0.0, 1.0), *rc::gen::inRange(1, 65)};
  }
  scene.duration = number(10.0, 1e4);
  scene.settle = number(0.0, 10.0);
  scene.seed = *rc::gen::arbitrary<std::uint64_t>();
  return scene;
}

RC_GTEST_PROP(CanonicalScene, ReadsBackBitForBit, ())
{
  const SceneDefinition scene = anyScene();
  const Scene back = sceneFromText(canonicalYaml(scene), "canonical");
  RC_ASSERT(same(back.definition, scene));
  RC_ASSERT(canonicalYaml(back.definition) == canonicalYaml(scene));
}

TEST(CanonicalScene, KeepsTheSignOfZeroAndTheSmallestNumbers)
{
  SceneDefinition scene = sceneFromText(GOOD_SCENE, "s.yaml").definition;
  scene.base.inclination = -0.0;
  scene.base.amplitude = 4.9406564584124654e-324;
  scene.base.phase = 0.1 + 0.2;
  EXPECT_TRUE(same(sceneFromText(canonicalYaml(scene), "s.yaml").definition, scene));
}

/// So that scenes that were recorded before there was the key keep their hash.
TEST(CanonicalScene, HasAWallHeightOnlyWhereOneIsSet)
{
  SceneDefinition scene = sceneFromText(GOOD_SCENE, "s.yaml").definition;
  EXPECT_EQ(canonicalYaml(scene).find("wall_height"), std::string::npos);
  const std::string hash = sceneHash(scene);
  scene.base.wall_height = 0.3;
  EXPECT_NE(canonicalYaml(scene).find("wall_height: 0.3"), std::string::npos);
  EXPECT_NE(sceneHash(scene), hash);
}

TEST(CanonicalScene, HasAnOrbitOnlyWhereTheDriveHasOne)
{
  SceneDefinition scene = sceneFromText(GOOD_SCENE, "s.yaml").definition;
  EXPECT_EQ(canonicalYaml(scene).find("horizontal"), std::string::npos);
  EXPECT_EQ(canonicalYaml(scene).find("harmonics"), std::string::npos);
  const std::string hash = sceneHash(scene);
  SceneDefinition oblique = scene;
  oblique.base.horizontal_amplitude = -0.001;
  EXPECT_NE(canonicalYaml(oblique).find("horizontal_amplitude: -0.001"), std::string::npos);
  EXPECT_NE(sceneHash(oblique), hash);
  scene.base.harmonics = {{2, 0.001, 0.0, 0.0, 0.5}, {3, 0.0, 0.0, 0.001, 0.0}};
  EXPECT_NE(canonicalYaml(scene).find("harmonics: [{multiple: 2, amplitude: 0.001, phase: 0, "
                                      "horizontal_amplitude: 0, horizontal_phase: 0.5}, {multiple: 3, "),
            std::string::npos)
      << canonicalYaml(scene);
  EXPECT_NE(sceneHash(scene), hash);
}

/// In place of the keys of a sawtooth, so that it can be read back.
TEST(CanonicalScene, HasAProfileOrASawtooth)
{
  SceneDefinition scene = sceneFromText(GOOD_SCENE, "s.yaml").definition;
  EXPECT_EQ(canonicalYaml(scene).find("profile"), std::string::npos);
  const std::string hash = sceneHash(scene);
  scene.base.profile = {{0.0, 0.0}, {0.006, 0.006}, {0.02, 0.0}};
  const std::string yaml = canonicalYaml(scene);
  EXPECT_NE(yaml.find("profile: [[0, 0], [0.006, 0.006], [0.02, 0]]"), std::string::npos) << yaml;
  EXPECT_EQ(yaml.find("tooth_"), std::string::npos);
  EXPECT_EQ(yaml.find("asymmetry"), std::string::npos);
  EXPECT_NE(sceneHash(scene), hash);
}

TEST(CanonicalScene, OfPlacedDisksReadsBackWithoutAWarning)
{
  const std::string text = goodSceneWith("pairs: []", "initial: [{species: A, x: 0.01, y: 0.1}]");
  const Scene scene = sceneFromText(text, "s.yaml");
  EXPECT_EQ(scene.warnings.size(), 2u);
  EXPECT_TRUE(sceneFromText(canonicalYaml(scene.definition), "canonical").warnings.empty());
}

TEST(CanonicalScene, WritesNumbersAsTheyAreSpelled)
{
  const std::string yaml = canonicalYaml(sceneFromText(GOOD_SCENE, "s.yaml").definition);
  EXPECT_NE(yaml.find("tooth_width: 0.02,"), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("gravity: 9.81\n"), std::string::npos) << yaml;
}

TEST(SceneHash, IsThatOfTheMotionAlone)
{
  const SceneDefinition scene = sceneFromText(GOOD_SCENE, "s.yaml").definition;
  SceneDefinition run = scene;
  run.seed = 99;
  run.duration = 55.0;
  run.settle = 5.0;
  EXPECT_EQ(sceneHash(run), sceneHash(scene));
  EXPECT_EQ(sceneHash(scene).size(), 16u);

  SceneDefinition motion = scene;
  motion.base.frequency = std::nextafter(motion.base.frequency, 99.0);
  EXPECT_NE(sceneHash(motion), sceneHash(scene));
}

TEST(RunHash, ChangesWithEveryKey)
{
  const SceneDefinition scene = sceneFromText(GOOD_SCENE, "s.yaml").definition;
  std::set<std::string> hashes = {runHash(scene)};
  SceneDefinition other = scene;
  other.seed = 99;
  hashes.insert(runHash(other));
  other.duration += 1.0;
  hashes.insert(runHash(other));
  other.settle += 1.0;
  hashes.insert(runHash(other));
  other.gravity = 9.0;
  hashes.insert(runHash(other));
  EXPECT_EQ(hashes.size(), 5u);
  EXPECT_EQ(runHash(scene), runHash(sceneFromText(canonicalYaml(scene), "c.yaml").definition));
}

/// Results that are kept by hash stay known when a key is added.
TEST(SceneHash, DoesNotChangeByAKeyThatCameLaterAndHasItsDefault)
{
  const SceneDefinition scene = sceneFromText(GOOD_SCENE, "s.yaml").definition;
  EXPECT_EQ(canonicalYaml(scene).find("restitution_speed"), std::string::npos);
  SceneDefinition slow = scene;
  slow.contact.restitution_speed = 0.5;
  EXPECT_NE(canonicalYaml(slow).find("collapse_events: 1000000, restitution_speed: 0.5}"), std::string::npos);
  EXPECT_NE(sceneHash(slow), sceneHash(scene));
}

TEST(SceneHash, IsTheSameForADensityAndItsCounts)
{
  const char* const counts = "species: [{name: A, count: 200, radius: 0.001, mass: 0.01}]\n";
  const char* const density = "species: [{name: A, radius: 0.001, mass: 0.01}]\ndensity: 1.0\n";
  EXPECT_EQ(sceneHash(sceneFromText(counts, "c").definition),
            sceneHash(sceneFromText(density, "d").definition));
}

/// Sizes come back as they were, and have a hash of their own; without spread they are not written.
TEST(CanonicalScene, KeepsSizes)
{
  const std::string plain = sceneHash(sceneFromText(GOOD_SCENE, "s.yaml").definition);
  for (const char* size :
       {"{distribution: uniform, spread: 0.3}", "{distribution: normal, spread: 0.1, mass_exponent: 2}",
        "{distribution: lognormal, spread: 0.5}",
        "{distribution: table, radii: [0.0005, 0.001, 0.003], weights: [0, 1, 2.5], by: mass, mass_exponent: "
        "2}"})
  {
    const std::string species = std::string("radius: 0.001, mass: 0.001, size: ") + size;
    const SceneDefinition scene =
        sceneFromText(goodSceneWith("radius: 0.001, mass: 0.001", species), "s.yaml").definition;
    const SceneDefinition again = sceneFromText(canonicalYaml(scene), "again").definition;
    EXPECT_TRUE(same(scene.species[0], again.species[0])) << canonicalYaml(scene);
    EXPECT_NE(sceneHash(scene), plain);
    EXPECT_EQ(sceneHash(scene), sceneHash(again));
  }
  const std::string none =
      goodSceneWith("mass: 0.001", "mass: 0.001, size: {distribution: normal, spread: 0}");
  EXPECT_EQ(sceneHash(sceneFromText(none, "s.yaml").definition), plain);
}

/// A density counts the expected diameters.
TEST(CanonicalScene, SplitsADensityByTheExpectedDiameters)
{
  const SceneDefinition scene =
      sceneFromText(
          "density: 4\nspecies:\n  - {name: A, radius: 0.001, mass: 0.001, size: {distribution: table, "
          "radii: [0.001, 0.003], weights: [0, 1]}}\n",
          "s.yaml")
          .definition;
  EXPECT_EQ(scene.species[0].count, 400);  // 4 * 0.4 m / 0.004 m
}

}  // namespace
}  // namespace ratchet_sieve
