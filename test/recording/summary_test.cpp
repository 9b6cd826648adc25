#include "ratchet_sieve/recording/summary.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

Json summaryOf(const SceneDefinition& scene)
{
  Simulation simulation(scene);
  const RunOutcome outcome = runToEnd(simulation, {});
  return summarize(simulation, outcome);
}

/// The names of an object's values, in order.
std::string keysOf(const Json& json)
{
  std::string keys;
  for (const auto& item : json.items())
    keys += (keys.empty() ? "" : " ") + item.key();
  return keys;
}

TEST(Summary, HasEveryFieldOthersRelyOn)
{
  const Json json = summaryOf(smallMixture());
  EXPECT_EQ(
      keysOf(json),
      "scene_hash seed version plan simulated_time wall_time events collisions short_to_long species quality "
      "separation separation_by_mass processed purity recovery accuracy steady steady_reason steady_needs "
      "base_impulse "
      "energy_start energy_end collapses max_overlap through_base warnings");
  EXPECT_EQ(keysOf(json["collisions"]), "disk_disk left_slope right_slope apex wall level");
  ASSERT_EQ(json["species"].size(), 2u);
  EXPECT_EQ(keysOf(json["species"][0]),
            "name count left right mean_vx mean_vx_stderr kinetic_translational kinetic_rotational "
            "collision_rate");
}

TEST(Summary, TellsWhatTheSimulationKnows)
{
  const SceneDefinition scene = smallMixture();
  Simulation simulation(scene);
  const RunOutcome outcome = runToEnd(simulation, {});
  const Json json = summarize(simulation, outcome);
  EXPECT_EQ(json["scene_hash"], sceneHash(scene));
  EXPECT_EQ(json["version"], version());
  EXPECT_EQ(json["simulated_time"], 2.0);
  EXPECT_EQ(json["events"], simulation.events());
  EXPECT_EQ(json["collisions"]["apex"], simulation.collisions().apex);
  EXPECT_EQ(json["species"][1]["name"], "B");
  EXPECT_EQ(json["species"][1]["count"], 6);
  EXPECT_EQ(json["species"][0]["mean_vx"].get<double>(), simulation.means()[0].mean_vx.value());
  EXPECT_EQ(json["species"][1]["collision_rate"].get<double>(), simulation.means()[1].collision_rate.value());
  EXPECT_EQ(json["base_impulse"][1].get<double>(), simulation.baseImpulse().y());
  EXPECT_EQ(json["energy_end"].get<double>(), simulation.energy());
}

TEST(Summary, HasThePlan)
{
  SceneDefinition scene = smallMixture();
  scene.base.amplitude = 0.0;
  scene.contact.contact_duration = 1e-4;
  scene.duration = 0.0;
  EXPECT_EQ(summaryOf(scene)["plan"], Json({{"pairs", true},
                                            {"steps", false},
                                            {"spin", true},
                                            {"drive", false},
                                            {"orbit", false},
                                            {"contact_times", true},
                                            {"search_above_band", false},
                                            {"simd", false}}));
}

TEST(Summary, SaysNullForWhatIsNotDefined)
{
  SceneDefinition scene = smallRing();
  scene.duration = 0.0;
  scene.species[0].count = 0;
  scene.species[1].count = 0;
  const Json json = summaryOf(scene);
  EXPECT_TRUE(json["quality"].is_null());
  EXPECT_TRUE(json["processed"].is_null());
  EXPECT_TRUE(json["short_to_long"].is_null());
  EXPECT_TRUE(json["species"][0]["mean_vx"].is_null());
  EXPECT_EQ(json.dump().find("nan"), std::string::npos);
}

TEST(Summary, ListsPairsOnlyWhereThereAreSeveral)
{
  SceneDefinition scene = smallRing();
  EXPECT_FALSE(summaryOf(scene).contains("pair_qualities"));
  scene.species.push_back(scene.species[1]);
  scene.species[2].name = "C";
  const Json pairs = summaryOf(scene)["pair_qualities"];
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[2]["species"], Json({"B", "C"}));
  EXPECT_TRUE(pairs[2]["quality"].is_null());
}

TEST(Summary, HasPurityAndRecoveryByNumberAndByMass)
{
  SceneDefinition scene = smallMixture();
  scene.boundary = Boundary::OPEN;
  scene.base.inclination = 0.3;
  scene.duration = 4.0;
  const Json json = summaryOf(scene);
  for (const char* key : {"purity", "recovery"})
    for (const char* bin : {"left", "right"})
      ASSERT_EQ(json[key][bin].size(), 2u);
  const auto left = json["species"][0]["left"].get<double>();
  const auto all = left + json["species"][1]["left"].get<double>();
  ASSERT_GT(left, 0.0);
  EXPECT_EQ(json["purity"]["left"][0]["name"], "A");
  EXPECT_DOUBLE_EQ(json["purity"]["left"][0]["number"].get<double>(), left / all);
  const double mass = left * scene.species[0].mass;
  EXPECT_NEAR(json["purity"]["left"][0]["mass"].get<double>(),
              mass / (mass + (all - left) * scene.species[1].mass), 1e-12);
  EXPECT_TRUE(summaryOf(smallRing())["purity"]["left"][0]["number"].is_null());
}

TEST(Summary, HasWhatTheSceneObserves)
{
  SceneDefinition scene = smallMixture();
  EXPECT_FALSE(summaryOf(scene).contains("mass_flow"));
  scene.boundary = Boundary::OPEN;
  scene.base.inclination = 0.3;
  scene.duration = 4.0;
  scene.observe = {"mass_flow", "residence_times"};
  const Json json = summaryOf(scene);
  const Json& flow = json["mass_flow"]["left"][0];
  EXPECT_EQ(flow["name"], "A");
  EXPECT_NEAR(flow["mean"].get<double>() * (4.0 - scene.settle), flow["mass"].get<double>(), 1e-12);
  EXPECT_EQ(flow["table"]["time"].size(), flow["table"]["flow"].size());
  const Json& times = json["residence_times"]["right"][1];
  EXPECT_TRUE(times["count"].is_number());
  EXPECT_EQ(times["mean"].is_null(), times["count"] == 0.0);
}

}  // namespace
}  // namespace ratchet_sieve
