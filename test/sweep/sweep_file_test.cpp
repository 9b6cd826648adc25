// A sweep file's cases, in their order, and its refusals.
#include <gtest/gtest.h>

#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_results.h"
#include "recording/errors.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

class SweepFile : public testing::Test
{
protected:
  Sweep load(const std::string& text) const { return loadSweep(written(directory_, "sweep.yaml", text)); }

  std::vector<std::string> names(const Sweep& sweep) const
  {
    std::vector<std::string> all;
    for (std::uint64_t k = 0; k < sweep.size(); ++k)
      all.push_back(CaseBuilder(sweep).name(k));
    return all;
  }

  void expectRefusal(const std::string& text, const std::string& line) const
  {
    std::string said = errorOf<SceneError>([&] { legalCases(load(text)); });
    for (std::size_t at; (at = said.find(directory_ / "")) != std::string::npos;)
      said.erase(at, (directory_ / "").size());
    EXPECT_EQ(said, line) << text;
  }

  ScratchDirectory directory_;
};

TEST_F(SweepFile, IsAProductWhoseLastKeyAndThenSeedVaryFastest)
{
  const Sweep sweep = load(std::string(SMALL_SCENE) + R"(
grid: {base.inclination: {from: -0.1, to: 0.2, count: 3}, boundary: [open, walled]}
zip: {species.0.radius: [0.001, 0.002], species.1.radius: [0.003, 0.004]}
cases: [{base.frequency: 20}, {gravity: 9}]
seed: {first: 7, count: 2}
)");
  std::vector<std::string> expected = {""};
  for (const std::vector<std::string>& axis : std::vector<std::vector<std::string>>{
           {"base.inclination=-0.1", "base.inclination=0.05", "base.inclination=0.2"},
           {" boundary=open", " boundary=walled"},
           {" species.0.radius=0.001 species.1.radius=0.003",
            " species.0.radius=0.002 species.1.radius=0.004"},
           {" base.frequency=20", " gravity=9"},
           {" seed=7", " seed=8"}})
  {
    std::vector<std::string> longer;
    for (const std::string& name : expected)
      for (const std::string& step : axis)
        longer.push_back(name + step);
    expected = longer;
  }
  EXPECT_EQ(names(sweep), expected);
}

TEST_F(SweepFile, MayListItsSeeds)
{
  const auto sweep_of = [this](const std::string& seeds)
  { return load(SMALL_SCENE + std::string("grid: {gravity: [8, 9]}\nseed: ") + seeds); };
  EXPECT_EQ(names(sweep_of("[7, 1]")), (std::vector<std::string>{"gravity=8 seed=7", "gravity=8 seed=1",
                                                                 "gravity=9 seed=7", "gravity=9 seed=1"}));
  EXPECT_EQ(CaseBuilder(sweep_of("[7, 1]")).at(3).scene.seed, 1u);
  EXPECT_NE(sweep_of("[7, 1]").fingerprint(), sweep_of("[7, 2]").fingerprint());
}

TEST_F(SweepFile, SetsWhatItSaysInTheScene)
{
  const Sweep sweep = load(std::string(SMALL_SCENE) + R"(
set: {duration: 5, base.phase: 1}
grid: {base.inclination: [0.25]}
cases: [{gravity: 9}, {species.1.name: "1"}]
seed: {first: 18446744073709551614, count: 2}
)");
  CaseBuilder builder(sweep);
  const SweepCase first = builder.at(0);
  EXPECT_EQ(first.scene.duration, 5.0);
  EXPECT_EQ(first.scene.base.phase, 1.0);
  EXPECT_EQ(first.scene.base.inclination, 0.25);
  EXPECT_EQ(first.scene.gravity, 9.0);
  EXPECT_EQ(first.scene.species[1].name, "B");
  EXPECT_EQ(first.scene.seed, 18446744073709551614u);
  const SweepCase last = builder.at(3);
  EXPECT_EQ(last.scene.gravity, 9.81);
  EXPECT_EQ(last.scene.species[1].name, "1");
  EXPECT_EQ(last.scene.seed, 18446744073709551615u);
  // A key without an assignment in a case gets the scene's value in the table.
  const CaseValues values = {
      {"base.inclination", "0.25"}, {"gravity", std::nullopt}, {"species.1.name", "\"1\""}};
  EXPECT_EQ(last.values, values);
  EXPECT_EQ(first.values[2].second, "B");
}

TEST_F(SweepFile, FindsItsSceneBesideItself)
{
  written(directory_, "own.yaml", "species: [{name: A, count: 1, radius: 0.001, mass: 0.01}]\n");
  const Sweep sweep = load("scene: own.yaml\n");
  EXPECT_EQ(sweep.size(), 1u);
  EXPECT_EQ(runHash(CaseBuilder(sweep).at(0).scene),
            runHash(loadSceneFile(directory_ / "own.yaml").definition));
}

TEST_F(SweepFile, RefusesWhatIsNoSweep)
{
  const std::string scene = "scene: {species: [{name: A, count: 1, radius: 0.001, mass: 0.01}]}\n";
  expectRefusal("[]", "sweep.yaml: sweep = a list: must be a map");
  expectRefusal("grid: {density: [1]}", "sweep.yaml:1: scene: missing");
  expectRefusal("scene: none.yaml", "none.yaml: no such file");
  expectRefusal("scene: [1]",
                "sweep.yaml:1: scene = a list: must be the path of a scene, or the scene itself");
  expectRefusal(scene + "gird: {density: [1]}", "sweep.yaml:2: gird: unknown key; did you mean grid?");
  expectRefusal(scene + "grid: {}", "sweep.yaml:2: grid: must have one key or more");
  expectRefusal(scene + "grid: {density: []}", "sweep.yaml:2: grid.density: must have one value or more");
  expectRefusal(scene + "grid: {density: [1, ~]}", "sweep.yaml:2: grid.density.1: must have a value");
  expectRefusal(scene + "grid: {density: 2}",
                "sweep.yaml:2: grid.density = 2: must be a list of values, or {from: .., to: .., count: ..}");
  expectRefusal(scene + "grid: {density: {from: 1, to: 2, cuont: 3}}",
                "sweep.yaml:2: grid.density.cuont: unknown key; did you mean count?");
  expectRefusal(scene + "grid: {density: {from: 1, to: 2, count: 0}}",
                "sweep.yaml:2: grid.density.count = 0: must be a number from 1 to 1e+15");
  expectRefusal(
      scene + "zip: {density: [1, 2], gravity: [9]}",
      "sweep.yaml:2: zip.gravity: has 1 values, but density has 2; the lists of a zip must be equally long");
  expectRefusal(scene + "cases: []", "sweep.yaml:2: cases: must have one case or more");
  expectRefusal(scene + "seed: {first: 1, count: 0}", "sweep.yaml:2: seed.count = 0: must be 1 or more");
  expectRefusal(scene + "seed: []", "sweep.yaml:2: seed: must have one seed or more");
  expectRefusal(scene + "seed: [3, 1, 3]", "sweep.yaml:2: seed.2 = 3: is given twice");
  expectRefusal(scene + "seed: {first: 18446744073709551615, count: 2}",
                "sweep.yaml:2: seed: the last seed must be below 2^64");
  expectRefusal(scene + "set: {density: 1}\ngrid: {density: [1]}",
                "sweep.yaml:3: grid: density is set in set as well");
  expectRefusal(scene + "grid: {base.inclination: [0, 0.1], base: [{teeth: 4}]}",
                "sweep.yaml:2: grid: base.inclination is a part of base, which is set in grid as well");
  expectRefusal(scene + "cases: [{species: []}]\nzip: {species.0.radius: [0.1]}",
                "sweep.yaml:3: zip: species.0.radius is a part of species, which is set in cases as well");
  expectRefusal(scene + "set: {base.teeth: 4}\ngrid: {base: [{teeth: 5}]}",
                "sweep.yaml:2: set: base.teeth is a part of base, which is set in grid as well");
  expectRefusal(scene + "set: {base.teeth: 4, base: {teeth: 5}}",
                "sweep.yaml:2: set: base.teeth is a part of base, which is set in set as well");
  expectRefusal(
      scene + "grid: {seed: [1]}",
      "sweep.yaml:2: grid: seeds are given by the sweep's own key, seed: {first: .., count: ..} or [..]");
  expectRefusal(
      scene + "cases: [{seed: 1}]\nseed: [2]",
      "sweep.yaml:2: cases: seeds are given by the sweep's own key, seed: {first: .., count: ..} or [..]");
  expectRefusal(scene +
                    "grid: {density: {from: 1, to: 2, count: 1000000000}, gravity: {from: 1, to: 2, count: "
                    "1000000000}}",
                "sweep.yaml: sweep: has more than 1000000000000000 cases");
  expectRefusal("a: &a {b: *a}",
                "sweep.yaml:1: not YAML: an alias (*NAME): not allowed; write out its value");
}

TEST_F(SweepFile, MaySweepAPartOfWhatIsSetInEveryCase)
{
  const Sweep sweep =
      load(SMALL_SCENE + std::string("set: {base: {teeth: 7}}\ngrid: {base.inclination: [0.1, 0.2]}\n"));
  const SweepCase last = CaseBuilder(sweep).at(1);
  EXPECT_EQ(last.scene.base.teeth, 7);
  EXPECT_EQ(last.scene.base.inclination, 0.2);
}

TEST_F(SweepFile, HasNoMoreKeysThanTheTableHasColumns)
{
  std::string keys;
  for (int k = 0; k < 501; ++k)
    keys += "species." + std::to_string(k) + ".radius: [0.1], ";
  expectRefusal("scene: {}\ngrid: {" + keys + "}", "sweep.yaml: sweep: has more than 500 keys");
}

TEST_F(SweepFile, RefusesACaseWhoseSceneIsIllegalAndSaysWhich)
{
  const std::string scene = "scene: {species: [{name: A, count: 1, radius: 0.001, mass: 0.01}]}\n";
  expectRefusal(scene + "grid: {base.teeth: [3, 4], base.inclination: [0, 9]}\nseed: {first: 4, count: 10}",
                "sweep.yaml: case 11 (base.teeth=3 base.inclination=9 seed=4): sweep.yaml: scene: "
                "base.inclination = 9: "
                "must be a number from -1.5 to 1.5 rad; did you mean 0.1571 rad (9 degrees)?");
  expectRefusal(scene + "cases: [{gravity: 9}, {base.inclinaton: 0.1}]",
                "sweep.yaml: case 2 (base.inclinaton=0.1): sweep.yaml: scene: base.inclinaton: unknown key; "
                "did you mean "
                "inclination?");
  expectRefusal(scene + "grid: {species.3.radius: [0.1]}",
                "sweep.yaml: case 1 (species.3.radius=0.1): override species.3.radius=0.1: 3 is not an index "
                "of species, a "
                "list of length 1");
  expectRefusal(scene + "grid: {species.0.radius: [0.1], species.00.radius: [0.2]}",
                "sweep.yaml: case 1 (species.0.radius=0.1 species.00.radius=0.2): override "
                "species.00.radius=0.2: 00 is "
                "not an index of species, a list of length 1");
  expectRefusal(scene + "grid: {base.teeth: [3, 4], base.length: [0.2]}",
                "sweep.yaml: case 1 (base.teeth=3 base.length=0.2): base.teeth: another swept key takes it "
                "out; sweep one of the two");
  // Only placing the disks shows that they overlap.
  expectRefusal(scene + "set: {initial: [{species: A, x: 0.1, y: 0.1}, {species: A, x: 0.1, y: 0.1}]}",
                "sweep.yaml: case 1 (the scene itself): initial.0 and initial.1 overlap by 0.002 m");
}

TEST(ConfigSweeps, AreLegal)
{
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CONFIG_DIRECTORY "/sweeps"))
  {
    EXPECT_NO_THROW(legalCases(loadSweep(entry.path()))) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 2);
}

TEST(RangeValue, HasEveryValueOfACoarserRange)
{
  for (const std::uint64_t intervals : {3u, 7u, 60u})
    for (std::uint64_t k = 0; k <= intervals; ++k)
      EXPECT_EQ(rangeValue(-0.3, 0.3, intervals + 1, k), rangeValue(-0.3, 0.3, 2 * intervals + 1, 2 * k))
          << k;
  EXPECT_EQ(rangeValue(-0.3, 0.3, 61, 1), -0.29);
  EXPECT_EQ(rangeValue(-0.3, 0.3, 61, 60), 0.3);
  EXPECT_EQ(rangeValue(10, 50, 5, 1), 20.0);
  EXPECT_EQ(rangeValue(0.7, 0.8, 1, 0), 0.7);
}

TEST(FlowText, ReadsBackToTheSame)
{
  for (const char* text :
       {"1", "-0.5e3", "true", "\"1\"", "\"\"", "a b", "\"a, b\"", "{a: [1, {b: \"x\"}], \"c: d\": []}"})
    EXPECT_EQ(flowText(YAML::Load(text)), text);
  EXPECT_EQ(flowText(YAML::Load("a: 1\nb:\n  - c, d\n  - 'e'\n")), "{a: 1, b: [\"c, d\", \"e\"]}");
}

}  // namespace
}  // namespace ratchet_sieve
