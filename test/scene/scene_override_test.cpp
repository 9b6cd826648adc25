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

std::string refusalOfOverride(const std::string& assignment)
{
  try
  {
    overridden({assignment});
    return "";
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
}

TEST(SceneOverride, SetsAKeyOfASection)
{
  EXPECT_EQ(overridden({"base.inclination=0.105"}).base.inclination, 0.105);
}

TEST(SceneOverride, SetsAKeyOfAListEntryAndLeavesTheOthers)
{
  const SceneDefinition scene = overridden({"species.1.radius=0.004"});
  EXPECT_EQ(scene.species[0].radius, 0.001);
  EXPECT_EQ(scene.species[1].radius, 0.004);
  EXPECT_EQ(scene.species[1].name, "B");
}

TEST(SceneOverride, MakesASectionThatIsNotThere)
{
  EXPECT_EQ(overridden({"pour.drop_height=0.1"}).pour.drop_height, 0.1);
}

TEST(SceneOverride, ReplacesAWholeList)
{
  const SceneDefinition scene = overridden({"species=[{name: C, count: 3, radius: 0.005, mass: 0.01}]"});
  ASSERT_EQ(scene.species.size(), 1u);
  EXPECT_EQ(scene.species[0].name, "C");
}

TEST(SceneOverride, OfNullTakesTheKeyOut)
{
  EXPECT_EQ(overridden({"base.inclination=0.105", "base.inclination=null"}).base.inclination, 0.0);
  EXPECT_TRUE(overridden({"pour=~"}).initial.empty());
  EXPECT_EQ(refusalOfOverride("species.0.radius=null"), "s.yaml:4: species.0.radius: missing");
}

/// A variable that is not set in a script, and an entry of a list, whose later entries would change their
/// names.
TEST(SceneOverride, OfNothingIsRefused)
{
  EXPECT_EQ(refusalOfOverride("settle="),
            "s.yaml:10: settle = nothing: must be a number from 0 to 1000000000 s");
  EXPECT_EQ(refusalOfOverride("species.1=null"), "s.yaml: species.1 = nothing: must be a map");
  EXPECT_EQ(refusalOfOverride("settle=\"null\""),
            "s.yaml: settle = \"null\": must be a number from 0 to 1000000000 s");
}

TEST(SceneOverride, OfAProfileReplacesTheSawtooth)
{
  const std::string profile = "base.profile=[[0, 0], [0.01, 0.004], [0.03, 0]]";
  const BaseDefinition base = overridden({"base.tooth_height=0.004", "base.asymmetry=0.2", profile}).base;
  EXPECT_EQ(base.toothWidth(), 0.03);
  EXPECT_EQ(base.outline().size(), 3u);
  EXPECT_EQ(base.outline()[1].n, 0.004);
}

TEST(SceneOverride, OfASawtoothNeedsThatTheProfileIsTakenOut)
{
  const std::string profile = "base.profile=[[0, 0], [0.01, 0.004], [0.03, 0]]";
  for (const std::string key : {"base.tooth_width", "base.tooth_height", "base.asymmetry"})
    try
    {
      overridden({profile, key + "=0.01"});
      ADD_FAILURE() << key;
    }
    catch (const SceneError& error)
    {
      EXPECT_EQ(error.what(),
                "override " + key +
                    "=0.01: base.profile gives the tooth; for a sawtooth take it out first, with "
                    "base.profile=null");
    }
  const BaseDefinition base = overridden({profile, "base.profile=null", "base.tooth_width=0.01"}).base;
  EXPECT_TRUE(base.isSawtooth());
  EXPECT_EQ(base.toothWidth(), 0.01);
}

TEST(SceneOverride, OfTwoTheLaterWins)
{
  EXPECT_EQ(overridden({"seed=5", "seed=6"}).seed, 6u);
}

TEST(SceneOverride, MayHoldAnEqualsSignInItsValue)
{
  EXPECT_EQ(refusalOfOverride("boundary=a=b"), "s.yaml: boundary = a=b: must be periodic, open or walled");
}

TEST(SceneOverride, OfABadValueNamesNoLineOfTheFile)
{
  EXPECT_EQ(refusalOfOverride("species.0.radius=-1"),
            "s.yaml: species.0.radius = -1: must be a number from 1e-09 to 1000 m");
}

/// As scenes of resets and of sweeps' cases are.
TEST(SceneOverride, OfACopyNamesNoLine)
{
  YAML::Node root = copyWithoutLines(YAML::Load(goodSceneWith("settle: 0.0", "settle: 5")));
  applyOverride(root, "duration=1");
  try
  {
    sceneFromYaml(root, "s.yaml");
    FAIL();
  }
  catch (const SceneError& error)
  {
    EXPECT_EQ(std::string(error.what()).rfind("s.yaml: settle = 5: must be at most the duration, 1 s", 0), 0u)
        << error.what();
  }
}

TEST(SceneOverride, KeepsQuotesApartFromNumbers)
{
  EXPECT_EQ(refusalOfOverride("settle=\"1\""),
            "s.yaml: settle = \"1\": must be a number from 0 to 1000000000 s");
}

TEST(SceneOverride, OfAnUnknownKeyIsRefused)
{
  EXPECT_EQ(refusalOfOverride("base.inclinatoin=0.1"),
            "s.yaml: base.inclinatoin: unknown key; did you mean inclination?");
}

TEST(SceneOverride, OfAnUnknownSectionIsRefused)
{
  EXPECT_EQ(refusalOfOverride("basis.teeth=2"), "s.yaml: basis: unknown key; did you mean base?");
}

TEST(SceneOverride, ThatIsNoAssignmentIsRefused)
{
  EXPECT_EQ(refusalOfOverride("seed"), "override seed: must be KEY=VALUE, such as base.inclination=0.105");
  EXPECT_EQ(refusalOfOverride("=3"), "override =3: must be KEY=VALUE, such as base.inclination=0.105");
}

TEST(SceneOverride, BeyondAListIsRefused)
{
  EXPECT_EQ(refusalOfOverride("species.2.radius=0.1"),
            "override species.2.radius=0.1: 2 is not an index of species, a list of length 2");
  EXPECT_EQ(refusalOfOverride("species.A.radius=0.1"),
            "override species.A.radius=0.1: A is not an index of species, a list of length 2");
  EXPECT_EQ(refusalOfOverride("species.00.radius=0.1"),
            "override species.00.radius=0.1: 00 is not an index of species, a list of length 2");
}

TEST(SceneOverride, BelowASingleValueIsRefused)
{
  EXPECT_EQ(refusalOfOverride("seed.low=0.1"),
            "override seed.low=0.1: seed is a single value and has no key low");
}

TEST(SceneOverride, WithAnEmptyPartIsRefused)
{
  EXPECT_EQ(refusalOfOverride("base..teeth=3"), "override base..teeth=3: the key has an empty part");
}

TEST(SceneOverride, WhoseValueIsNoYamlIsRefused)
{
  EXPECT_EQ(refusalOfOverride("species=[{"),
            "override species=[{: the value is not YAML: end of map flow not found");
}

TEST(SceneOverride, ThatHoldsItselfOrMultipliesIsRefused)
{
  const std::string alias = "the value is not YAML: an alias (*NAME): not allowed; write out its value";
  EXPECT_EQ(refusalOfOverride("base=&a [*a]"), "override base=&a [*a]: " + alias);
  std::string bomb = "base=[&a0 [1, 1]";
  for (int i = 1; i < 40; ++i)
  {
    const std::string last = std::to_string(i - 1);
    bomb += ", &a" + std::to_string(i) + " [*a" + last + ", *a" + last + "]";
  }
  EXPECT_EQ(refusalOfOverride(bomb + "]"), "override " + bomb.substr(0, 60) + "...: " + alias);
}

TEST(SceneOverride, IsShownInOneLine)
{
  EXPECT_EQ(refusalOfOverride("a\nb"), "override a b: must be KEY=VALUE, such as base.inclination=0.105");
  EXPECT_EQ(refusalOfOverride("seed.a\nb=1"),
            "override seed.a b=1: seed is a single value and has no key a b");
}

}  // namespace
}  // namespace ratchet_sieve
