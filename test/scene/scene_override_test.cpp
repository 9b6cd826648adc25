#include <gtest/gtest.h>

#include "scene_texts.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition overridden(const std::vector<std::string>& assignments)
{
  YAML::Node root = YAML::Load(GOOD_SCENE);
  for (const std::string& assignment : assignments)
    applyOverride(root, assignment);
  return sceneFromYaml(root, "s.yaml").definition;
}

std::string refusalOfOverrides(const std::vector<std::string>& assignments)
{
  return refusalBy([&] { overridden(assignments); });
}

TEST(SceneOverride, SetsAKeyOfASectionOrOfAListsEntryAndTheLastWins)
{
  const SceneDefinition scene = overridden(
      {"base.inclination=0.1", "species.1.radius=0.004", "pour.drop_height=0.1", "seed=5", "seed=6"});
  EXPECT_EQ(scene.base.inclination, 0.1);
  EXPECT_EQ(scene.species[0].radius, 0.001);
  EXPECT_EQ(scene.species[1].radius, 0.004);
  EXPECT_EQ(scene.pour.drop_height, 0.1);
  EXPECT_EQ(scene.seed, 6u);
  const auto species = overridden({"species=[{name: C, count: 3, radius: 0.005, mass: 0.01}]"}).species;
  ASSERT_EQ(species.size(), 1u);
  EXPECT_EQ(species[0].count, 3);
}

TEST(SceneOverride, OfAProfileReplacesTheSawtoothUntilItIsTakenOut)
{
  const std::string profile = "base.profile=[[0, 0], [0.01, 0.004], [0.03, 0]]";
  const BaseDefinition base = overridden({"base.tooth_height=0.004", "base.asymmetry=0.2", profile}).base;
  EXPECT_EQ(base.toothWidth(), 0.03);
  EXPECT_EQ(base.outline().size(), 3u);
  for (const std::string key : {"base.tooth_width", "base.tooth_height", "base.asymmetry"})
    EXPECT_EQ(
        refusalOfOverrides({profile, key + "=0.01"}),
        "override " + key + "=0.01: base.profile gives the tooth; take it out first, with base.profile=null");
  EXPECT_EQ(overridden({profile, "base.profile=null", "base.tooth_width=0.01"}).base.toothWidth(), 0.01);
}

TEST(SceneOverride, OfALengthReplacesTheTeethUntilItIsTakenOut)
{
  EXPECT_EQ(overridden({"base.length=0.6"}).base.teeth, 30);
  EXPECT_EQ(overridden({"base.length=0.6", "base.tooth_width=0.03"}).base.teeth, 20);
  EXPECT_EQ(overridden({"base.length=0.6", "base.profile=[[0, 0], [0.01, 0.004], [0.05, 0]]"}).base.teeth,
            12);
  EXPECT_EQ(refusalOfOverrides({"base.length=0.6", "base.teeth=7"}),
            "override base.teeth=7: base.length gives the number of teeth; take it out first, with "
            "base.length=null");
  EXPECT_EQ(overridden({"base.length=0.6", "base.length=null", "base.teeth=7"}).base.teeth, 7);
}

TEST(SceneOverride, ThatIsWrongIsRefused)
{
  const std::string number = ": must be a number from 0 to 1000000000 s";
  const std::string assignment = ": must be KEY=VALUE, such as base.inclination=0.105";
  for (const auto& [override, refusal] : std::vector<std::pair<std::string, std::string>>{
           // A variable that is not set in a script, and an entry of a list, whose later entries would change
           // their names.
           {"settle=", "s.yaml:10: settle = nothing" + number},
           {"species.1=null", "s.yaml: species.1 = nothing: must be a map"},
           {"settle=\"null\"", "s.yaml: settle = \"null\"" + number},
           {"settle=\"1\"", "s.yaml: settle = \"1\"" + number},
           {"boundary=a=b", "s.yaml: boundary = a=b: must be periodic, open or walled"},
           {"base.inclinatoin=0.1", "s.yaml: base.inclinatoin: unknown key; did you mean inclination?"},
           {"basis.teeth=2", "s.yaml: basis: unknown key; did you mean base?"},
           {"seed", "override seed" + assignment},
           {"=3", "override =3" + assignment},
           {"a\nb", "override a b" + assignment},
           {"species.2.radius=0.1",
            "override species.2.radius=0.1: 2 is not an index of species, a list of length 2"},
           {"species.A.radius=0.1",
            "override species.A.radius=0.1: A is not an index of species, a list of length 2"},
           {"species.00.radius=0.1",
            "override species.00.radius=0.1: 00 is not an index of species, a list of length 2"},
           {"seed.a\nb=1", "override seed.a b=1: seed is a single value and has no key a b"},
           {"base..teeth=3", "override base..teeth=3: the key has an empty part"},
           {"species=[{", "override species=[{: the value is not YAML: end of map flow not found"}})
    EXPECT_EQ(refusalOfOverrides({override}), refusal);
}

TEST(SceneOverride, OfNullTakesTheKeyOut)
{
  EXPECT_EQ(overridden({"base.inclination=0.105", "base.inclination=null"}).base.inclination, 0.0);
  EXPECT_TRUE(overridden({"pour=~"}).initial.empty());
  EXPECT_EQ(refusalOfOverrides({"species.0.radius=null"}), "s.yaml:4: species.0.radius: missing");
}

/// As scenes of resets and of sweeps' cases are.
TEST(SceneOverride, OfACopyNamesNoLine)
{
  YAML::Node root = copyWithoutLines(YAML::Load(goodSceneWith("settle: 0.0", "settle: 5")));
  applyOverride(root, "duration=1");
  const std::string refusal = refusalBy([&] { sceneFromYaml(root, "s.yaml"); });
  EXPECT_EQ(refusal.rfind("s.yaml: settle = 5: must be at most the duration, 1 s", 0), 0u) << refusal;
}

TEST(SceneOverride, ThatHoldsItselfOrMultipliesIsRefused)
{
  const std::string alias = "the value is not YAML: an alias (*NAME): not allowed; write out its value";
  EXPECT_EQ(refusalOfOverrides({"base=&a [*a]"}), "override base=&a [*a]: " + alias);
  std::string bomb = "base=[&a0 [1, 1]";
  for (int i = 1; i < 40; ++i)
  {
    const std::string last = std::to_string(i - 1);
    bomb += ", &a" + std::to_string(i) + " [*a" + last + ", *a" + last + "]";
  }
  EXPECT_EQ(refusalOfOverrides({bomb + "]"}), "override " + bomb.substr(0, 60) + "...: " + alias);
}

}  // namespace
}  // namespace ratchet_sieve
