#include <string>

#include <gtest/gtest.h>

#include "scene_texts.h"

namespace ratchet_sieve
{
namespace
{

struct Refusal
{
  std::string from;     ///< a piece of the good scene
  std::string to;       ///< what spoils it
  std::string message;  ///< after the file's name
};

const char* const A_MASS = "mass: 0.001";
const char* const TOOTH = "teeth: 20, tooth_width: 0.02";

const Refusal REFUSALS[] = {
    {"boundary:", "bondary:", "2: bondary: unknown key; did you mean boundary?"},
    {"tooth_width:", "tooth_witdh:", "1: base.tooth_witdh: unknown key; did you mean tooth_width?"},
    {"mass: 0.002", "weight: 0.002",
     "5: species.1.weight: unknown key; must be one of count, density, friction, inertia_factor, mass, name, "
     "radius, restitution, share, share_by, size, tangential_restitution"},
    {"teeth: 20", "harmonics: [{multiple: 2, amplitud: 1}], teeth: 20",
     "1: base.harmonics.0.amplitud: unknown key; did you mean amplitude?"},
    {"count: 10, ", "", "4: species.0.count: missing"},
    {"mass: 0.001", "mass: 0.001, density: 2500",
     "4: species.0.mass: must be absent because density gives it"},
    {"radius: 0.001, mass: 0.001", "radius: 100, density: 7800",
     "4: species.0.density = 7800: gives a mass of 32672563597.333847 kg; must be a number from 1e-18 to "
     "1000000 kg"},
    {"teeth: 20", "teeth: 20, length: 0.4",
     "1: base.teeth: must be absent because base.length gives the number of teeth"},
    {"teeth: 20", "length: 0.0099",
     "1: base.length = 0.0099: must be that of 1 to 1000000 teeth, each 0.02 m wide"},
    {"teeth: 20, tooth_width: 0.02", "length: 0.4, profile: [[0, 0], [1e-7, 0]]",
     "1: base.length = 0.4: must be that of 1 to 1000000 teeth, each 1e-07 m wide"},
    {"count: 10, radius: 0.001", "count: 10, share_by: volume, radius: 0.001",
     "4: species.0.share_by = volume: must be number or mass"},
    {"count: 10, radius: 0.002", "count: 10, share_by: mass, radius: 0.002",
     "5: species.1.share_by = mass: must be the same for all species; that of A is number"},
    {"count: 10, radius: 0.001", "count: 10, share_by: mass, radius: 0.001",
     "4: species.0.share_by = mass: must be the same for all species; that of B is number"},
    {"teeth: 20", "teeth: 20, teeth: 21", "1: base.teeth: is given twice"},
    {"{teeth: 20, tooth_width: 0.02}", "[1, 2]", "1: base = a list: must be a map"},
    {"{teeth: 20, tooth_width: 0.02}", "", "1: base = nothing: must be a map"},
    {"[]", "{}", "6: pairs = a map: must be a list"},
    {"seed: 1", "[a]: 1", "11: scene: a key must be a word"},
    {"radius: 0.001", "radius: wide", "4: species.0.radius = wide: must be a number from 1e-09 to 1000 m"},
    {"radius: 0.001", "radius: \"0.001\"",
     "4: species.0.radius = \"0.001\": must be a number from 1e-09 to 1000 m"},
    {"radius: 0.001", "radius: true", "4: species.0.radius = true: must be a number from 1e-09 to 1000 m"},
    {"radius: 0.001", "radius: .nan", "4: species.0.radius = .nan: must be a number from 1e-09 to 1000 m"},
    {"10.0", "1e999", "9: duration = 1e999: must be a number from 0 to 1000000000 s"},
    {"10.0", "10s", "9: duration = 10s: must be a number from 0 to 1000000000 s"},
    {"mass: 0.001", "mass: -0.001", "4: species.0.mass = -0.001: must be a number from 1e-18 to 1000000 kg"},
    {"mass: 0.001", "mass: 0.001, inertia_factor: 0",
     "4: species.0.inertia_factor = 0: must be a number from 1e-06 to 1"},
    {"teeth: 20", "inclination: 11",
     "1: base.inclination = 11: must be a number from -1.5 to 1.5 rad; did you mean 0.192 rad (11 degrees)?"},
    {"mass: 0.001", "mass: 0.001, restitution: 60",
     "4: species.0.restitution = 60: must be a number from 0 to 1; did you mean 0.6 (60 %)?"},
    {"count: 10", "count: 1.5", "4: species.0.count = 1.5: must be an integer from 0 to 10000000"},
    {"count: 10", "count: 99999999999",
     "4: species.0.count = 99999999999: must be an integer from 0 to 10000000"},
    {"seed: 1", "seed: -1", "11: seed = -1: must be an integer from 0 to 18446744073709551615"},
    {"seed: 1", "seed: 18446744073709551616",
     "11: seed = 18446744073709551616: must be an integer from 0 to 18446744073709551615"},
    {"pair_collisions: true", "pair_collisions: 1", "7: contact.pair_collisions = 1: must be true or false"},
    {"periodic", "closed", "2: boundary = closed: must be periodic, open or walled"},
    {"name: A", "name: 'A,B'",
     "4: species.0.name = \"A,B\": must be a name of 1 to 64 letters, digits, '_', '-' or '.'"},
    {"name: A", "name: ''",
     "4: species.0.name = \"\": must be a name of 1 to 64 letters, digits, '_', '-' or '.'"},
    {"periodic", "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa",
     "2: boundary = aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...: must be periodic, open "
     "or walled"},
    {"boundary: periodic", "observe: [mass_flow, colour]",
     "2: observe.1 = colour: must be one of residence_times, height_profile, mass_flow"},
    {"boundary: periodic", "observe: [mass_flow, mass_flow]", "2: observe.1 = mass_flow: is given twice"},
    {"periodic", "\"a\\nb\"", "2: boundary = \"a b\": must be periodic, open or walled"},
    {A_MASS, "mass: 0.001, size: {distribution: uniform, spread: 1}",
     "4: species.0.size.spread = 1: must be below 1: every radius must be above 0"},
    {A_MASS, "mass: 0.001, size: {distribution: normal, spread: 0.34}",
     "4: species.0.size.spread = 0.34: must be below 1/3: every radius must be above 0, and the distribution "
     "is cut at 3 standard deviations"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [0.001]}",
     "4: species.0.size.weights: missing"},
    {A_MASS, "mass: 0.001, size: {distribution: table, spread: 0.1, radii: [0.001], weights: [1]}",
     "4: species.0.size.spread: unknown key; must be one of by, distribution, mass_exponent, radii, weights"},
    {A_MASS, "mass: 0.001, size: {distribution: uniform, spread: 0.1, weights: [1]}",
     "4: species.0.size.weights: unknown key; must be one of distribution, mass_exponent, spread"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [0.001, 0.002], weights: [1]}",
     "4: species.0.size.weights: must have as many numbers as radii, 2"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [], weights: []}",
     "4: species.0.size.radii: must have 1 to 1000 numbers"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [0.001, 0.002], weights: [0, 0]}",
     "4: species.0.size.weights: needs a weight above 0"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [0.001, 0.001], weights: [1, 1]}",
     "4: species.0.size.radii.1 = 0.001: must be larger than the radius before, 0.001 m"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [0.002, 0.003], weights: [1, 1]}",
     "4: species.0.radius = 0.001: must be within size.radii, from 0.002 to 0.003 m"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [0.5, 2], weights: [1, 1]}",
     "4: species.0.radius = 0.001: must be within size.radii, from 0.5 to 2 m; are size.radii in mm?"},
    {"radius: 0.001, mass: 0.001",
     "radius: 1, mass: 0.001, size: {distribution: table, radii: [0.0005, 0.002], weights: [1, 1]}",
     "4: species.0.radius = 1: must be within size.radii, from 0.0005 to 0.002 m; did you mean 0.001 m?"},
    {"radius: 0.001, mass: 0.001",
     "radius: 1, mass: 0.001, size: {distribution: table, radii: [0.5, 2], weights: [1, 1]}",
     "4: species.0.size: the largest diameter, 4 m, must be at most the base's width (teeth times "
     "tooth_width), 0.4 m; are its radii in mm?"},
    {A_MASS, "mass: 0.001, size: {distribution: table, radii: [0.001, 0.25], weights: [0, 1]}",
     "4: species.0.size: the largest diameter, 0.5 m, must be at most the base's width (teeth times "
     "tooth_width), 0.4 m"},
    {"name: B", "name: A", "5: species.1.name = A: another species has this name already"},
    {"[]", "[{species: [A, C]}]", "6: pairs.0.species.1 = C: unknown species; must be one of A, B"},
    {"[]", "[{species: [A]}]", "6: pairs.0.species: must be a list of two species"},
    {"[]", "[{species: [A, A]}]",
     "6: pairs.0.species: must be two different species; contacts within a species have its own "
     "coefficients"},
    {"[]", "[{species: [A, B]}, {species: [B, A]}]",
     "6: pairs.1.species: another pair has these two species already"},
    {"pairs: []", "initial: [{species: C, x: 0, y: 0.1}]",
     "6: initial.0.species = C: unknown species; must be one of A, B"},
    {"pairs: []", "initial: [{species: A, x: 0}]", "6: initial.0.y: missing"},
    {"pairs: []", "initial: [{species: A, x: 0, y: 0.1}]\ndensity: 1.0",
     "7: density: must be absent because initial places the disks"},
    {"settle: 0.0", "settle: 10.5",
     "10: settle = 10.5: must be at most the duration, 10 s; change settle or duration in the scene, or with "
     "--set settle=0 or --duration of sieve_run"},
    {"pairs: []", "density: 1000000",
     "6: density = 1000000: too dense: species A would have more than 10000000 disks"},
    {"radius: 0.002", "radius: 0.21",
     "5: species.1.radius = 0.21: the diameter must be at most the base's width (teeth times tooth_width), "
     "0.4 m"},
    {"radius: 0.002", "radius: 2",
     "5: species.1.radius = 2: the diameter must be at most the base's width (teeth times tooth_width), 0.4 "
     "m; did you mean 0.002 m?"},
    {"radius: 0.001", "radius: 1e-7",
     "4: species.0.radius = 1e-7: must be at least 3.552713678800501e-07 m in this scene, because the base's "
     "width is 0.4 m: with double precision, smaller disks would overlap by more than 1e-9 of their radius"},
    {"tooth_width: 0.02}\nboundary: periodic\nspecies:\n  - {name: A, count: 10, radius: 0.001",
     "tooth_width: 0.02, amplitude: 1, frequency: 1000}\nspecies:\n  - {name: A, count: 10, radius: 1e-5",
     "3: species.0.radius = 1e-5: must be at least 8.719671245021578e-05 m in this scene, because the "
     "drive's speed is 6283.19 m/s: with double precision, smaller disks would overlap by more than 1e-9 of "
     "their radius"},
    {"pairs: []", "pour: {from: 0.5}", "6: pour.from = 0.5: must be at most the base's width, 0.4 m"},
    {"feed: {rate: 0.0}", "feed: {from: 0.1, to: 200}",
     "8: feed.to = 200: must be at most the base's width, 0.4 m; did you mean 0.2 m?"},
    {"pairs: []", "pour: {from: 0.3, to: 0.2}", "6: pour.to = 0.2: must be at least pour.from, 0.3 m"},
    {"pairs: []", "accuracy: {method: steps, step: 4}",
     "6: accuracy.step = 4: must be a number from 1e-07 to 0.1 s; did you mean 0.004 s (4 ms)?"},
    {TOOTH, "profile: [[0, 0]]",
     "1: base.profile = a list: must be a list of 2 to 10000 corners [s, n], each number -1000 to 1000 m"},
    {TOOTH, "profile: [[0, 0], [0.02]]", "1: base.profile.1: must be two numbers, [s, n]"},
    {TOOTH, "profile: [[0, 0], [0.01, .inf], [0.02, 0]]",
     "1: base.profile.1.1 = .inf: must be a number from -1000 to 1000 m"},
    {TOOTH, "profile: [[0, 0], [0.01, 0.005], [0.009, 0.006], [0.02, 0]]",
     "1: base.profile.2: s = 0.009 m is before the corner before, s = 0.01 m: corners go from left to right, "
     "and a tooth must have no overhang"},
    {TOOTH, "profile: [[0.001, 0], [0.02, 0]]",
     "1: base.profile.0: must be [0, 0]: a tooth begins there, at its left end"},
    {TOOTH, "profile: [[0, 0], [0.02, 0.001]]",
     "1: base.profile.1: n = 0.001 m must be 0: a tooth ends as high as it begins"},
    {TOOTH, "profile: [[0, 0], [0, 0.01], [0, 0]]",
     "1: base.profile.2: leads back along a vertical face: a tooth must have no wall or gap without "
     "thickness"},
    {TOOTH, "profile: [[0, 0], [0.01, 0.001], [0.01, 0.001], [0.02, 0]]",
     "1: base.profile.2: must be at least 1e-09 m from the corner before"},
    {TOOTH, "profile: [[0, 0], [0, -0.01], [0.02, -0.01], [0.02, 0]]",
     "1: base.profile.3: leads back along the next tooth's first face: there must be no wall or gap without "
     "thickness"},
    {TOOTH, "tooth_width: 0.02, profile: [[0, 0], [0.02, 0]]",
     "1: base.tooth_width: must be absent because base.profile gives the tooth"},
};

TEST(SceneRefusals, NameFileLineKeyValueAndWhatIsAllowed)
{
  for (const Refusal& one : REFUSALS)
    EXPECT_EQ(refusalOf(goodSceneWith(one.from, one.to)), "s.yaml:" + one.message);
}

/// Millimetres for metres are doubted as those of a sawtooth.
TEST(SceneProfile, InMillimetresIsDoubted)
{
  const Scene scene =
      sceneFromText(goodSceneWith("tooth_width: 0.02", "profile: [[0, 0], [6, 6], [20, 0]]"), "s.yaml");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("base.profile's width = 20 m"), std::string::npos) << scene.warnings[0];
  EXPECT_NE(scene.warnings[0].find("did you mean 0.02 m?"), std::string::npos) << scene.warnings[0];
}

TEST(SceneText, ThatIsWrongAsAWholeIsRefused)
{
  const std::string none = "species: [{name: A, share: 0, radius: 0.001, mass: 0.001}]\n";
  for (const auto& [text, refusal] : std::vector<std::pair<std::string, std::string>>{
           {"base: {teeth: 20\nspecies: ]\n", "s.yaml:2: not YAML: end of map flow not found"},
           {"", "s.yaml: scene = nothing: must be a map"},
           {"seed: 2\n", "s.yaml:1: species: missing"},
           {"species: []\n", "s.yaml:1: species: must have at least one species"},
           {std::string(GOOD_SCENE) + "---\nseed: 2\n",
            "s.yaml:12: not YAML: a second document; a scene must be a single one"},
           {std::string(100000, '['), "s.yaml:1: not YAML: lists and maps nest deeper than 16"},
           {std::string((16u << 20) + 1, '\n'), "s.yaml: too large; must have at most 16777216 bytes"},
           {none + "feed: {rate: 2.0}\n", "s.yaml:2: feed.rate = 2.0: needs a species with a share above 0"},
           {none + "density: 1.0\n", "s.yaml:2: density = 1.0: needs a species with a share above 0"}})
    EXPECT_EQ(refusalOf(text), refusal);
}

/// An override of one place would change the other as well.
TEST(SceneText, WithAnAliasIsRefused)
{
  std::string text = goodSceneWith("radius: 0.001", "radius: &r 0.001");
  EXPECT_EQ(refusalOf(text), "");
  EXPECT_EQ(refusalOf(text.replace(text.find("0.002"), 5, "*r")),
            "s.yaml:5: not YAML: an alias (*NAME): not allowed; write out its value");
}

TEST(SceneFile, ThatCannotBeReadIsRefused)
{
  for (const auto& [path, why] : std::vector<std::pair<std::string, std::string>>{
           {"no_such_directory/scene.yaml", "no such file"},
           {"/", "is a directory"},
           {"/dev/null", "scene = nothing: must be a map"},
           {"/dev/zero", "too large; must have at most 16777216 bytes"}})
    EXPECT_EQ(refusalBy([&, file = path] { loadSceneFile(file); }), path + ": " + why);
}

TEST(SceneText, IsShownInOneLineAndCut)
{
  EXPECT_EQ(refusalOf(goodSceneWith("seed:", "\"se\\ned\\x7f\":")),
            "s.yaml:11: se ed : unknown key; did you mean seed?");
  const std::string refusal = refusalOf(goodSceneWith("seed:", std::string(1000, 'x') + ":"));
  EXPECT_EQ(refusal.rfind("s.yaml:11: " + std::string(60, 'x') + "...: unknown key; must be one of ", 0), 0u)
      << refusal;
}

TEST(SceneRules, SpeciesAndDisksHaveALimit)
{
  std::string species = "species:\n";
  for (int i = 0; i < 256; ++i)
    species += "  - {name: S" + std::to_string(i) + ", count: 39062, radius: 0.001, mass: 1}\n";
  EXPECT_EQ(refusalOf(species), "");
  EXPECT_EQ(refusalOf(species + "  - {name: X, count: 1, radius: 0.001, mass: 1}\n"),
            "s.yaml:2: species: must have at most 256 species");
  EXPECT_EQ(refusalOf("species:\n  - {name: A, count: 10000000, radius: 0.001, mass: 1}\n  - {name: B, "
                      "count: 1, radius: 0.001, mass: 1}\n"),
            "s.yaml:2: species: must have at most 10000000 disks in total");
}

TEST(SceneRules, AWideDiskIsRefusedOnlyWhereItMatters)
{
  const auto scene = [](const std::string& rest)
  { return "base: {teeth: 1, tooth_width: 0.02}\nspecies: [{name: A, radius: 0.011, mass: 0.001, " + rest; };
  const std::string refusal =
      "s.yaml:2: species.0.radius = 0.011: the diameter must be at most the base's width (teeth times "
      "tooth_width), 0.02 m";
  EXPECT_EQ(refusalOf(scene("count: 1}]\n")), "");  // alone on its ring
  EXPECT_EQ(refusalOf(scene("count: 2}]\n")), refusal);
  EXPECT_EQ(refusalOf(scene("count: 2}]\ncontact: {pair_collisions: false}\n")), "");
  EXPECT_EQ(refusalOf(scene("count: 1}]\nboundary: open\n")), refusal);
  EXPECT_EQ(refusalOf(scene("count: 0}]\nboundary: walled\nfeed: {rate: 1}\n")), refusal);
  EXPECT_EQ(refusalOf(scene("count: 0}]\nboundary: open\n")), "");
}

}  // namespace
}  // namespace ratchet_sieve
