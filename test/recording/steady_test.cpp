#include "ratchet_sieve/recording/steady.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/summary.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition fedMixture()
{
  SceneDefinition scene = smallMixture();
  scene.base.inclination = 0.1;
  scene.feed.rate = 40.0;
  scene.duration = 20.0;
  return scene;
}

nlohmann::ordered_json endOfRun(const SceneDefinition& scene)
{
  Simulation simulation(scene);
  const RunOutcome outcome = runToEnd(simulation, {});
  return summarize(simulation, outcome);
}

std::string reasonOf(const SceneDefinition& scene)
{
  const nlohmann::ordered_json summary = endOfRun(scene);
  EXPECT_TRUE(summary.at("steady").is_null());
  return summary.at("steady_reason").get<std::string>();
}

TEST(Steady, IsWhatLeftSinceTheMachineHasFilled)
{
  const SceneDefinition scene = fedMixture();
  Simulation simulation(scene);
  simulation.advanceTo(scene.duration);
  const Steadiness found = steadinessOf(simulation);
  ASSERT_TRUE(found.state) << found.reason;
  const SteadyState& state = *found.state;
  EXPECT_GT(state.from, 0.0);
  Simulation before(scene);
  before.advanceTo(state.from);
  const FlowSeries series = simulation.flowSeries();
  const double end = series.start + series.block_time * static_cast<double>(series.species[0].inside.size());
  Simulation until(scene);
  until.advanceTo(end);
  double exits = 0.0;
  std::vector<SpeciesBins> bins = until.bins();
  for (std::size_t s = 0; s < 2; ++s)
  {
    bins[s].left -= before.bins()[s].left;
    bins[s].right -= before.bins()[s].right;
    EXPECT_EQ(state.species[s].left.number, static_cast<double>(bins[s].left));
    EXPECT_EQ(state.species[s].right.number, static_cast<double>(bins[s].right));
    EXPECT_NEAR(state.species[s].left.mass, until.bins()[s].left_mass - before.bins()[s].left_mass, 1e-12);
    exits += static_cast<double>(bins[s].counted());
  }
  EXPECT_EQ(state.separation->value, *bestSeparation(bins).separation);
  const std::vector<SpeciesShares> shares = binShares(bins);
  EXPECT_DOUBLE_EQ(state.species[1].left.purity.number->value, *shares[1].left.number.purity);
  EXPECT_DOUBLE_EQ(state.species[1].right.recovery.number->value, *shares[1].right.number.recovery);
  EXPECT_NEAR(state.throughput->value, exits / (end - state.from), 1e-9);
  EXPECT_NEAR(state.throughput->value, scene.feed.rate, state.throughput->half_width);
}

TEST(Steady, HasItsNumbersWithErrorsInTheSummary)
{
  const nlohmann::ordered_json summary = endOfRun(fedMixture());
  EXPECT_TRUE(summary.at("steady_reason").is_null());
  const nlohmann::ordered_json& steady = summary.at("steady");
  std::string keys;
  for (const auto& item : steady.items())
    keys += item.key() + ' ';
  EXPECT_EQ(keys, "from separation separation_by_mass quality purity recovery throughput inside exits ");
  for (const char* pointer :
       {"/separation", "/separation_by_mass", "/quality", "/throughput/mass", "/throughput/number", "/inside",
        "/purity/left/0/number", "/purity/right/1/mass", "/recovery/left/0/mass", "/recovery/right/1/number"})
  {
    const auto& estimate = steady.at(nlohmann::ordered_json::json_pointer(pointer));
    EXPECT_TRUE(estimate.at("value").is_number()) << pointer;
    EXPECT_GT(estimate.at("half_width").get<double>(), 0.0) << pointer;
  }
  const auto by_mass = [&](int species)
  { return steady["recovery"]["left"][species]["mass"]["value"].get<double>(); };
  EXPECT_NEAR(steady["separation_by_mass"]["value"].get<double>(), by_mass(0) - by_mass(1), 1e-12);
}

TEST(Steady, HasAReasonWhereThereIsNone)
{
  EXPECT_EQ(reasonOf(smallMixture()), "no feed: nothing comes in");
  SceneDefinition ring = smallRing();
  ring.feed.rate = 1.0;
  EXPECT_EQ(reasonOf(ring), "no end: nothing leaves a periodic base");
  SceneDefinition brief = fedMixture();
  brief.duration = 1.0;
  EXPECT_EQ(reasonOf(brief).substr(0, 11), "too short: ");
  SceneDefinition sparse = fedMixture();
  sparse.feed.rate = 0.2;
  for (SpeciesDefinition& species : sparse.species)
    species.count = 0;
  EXPECT_EQ(reasonOf(sparse).substr(0, 14), "too few left: ");
  SceneDefinition choked = chokedFeeder();
  choked.feed.on_choke = ChokeAction::STOP;
  EXPECT_EQ(reasonOf(choked).substr(0, 20), "the base is choked: ");
}

TEST(Steady, WarnsWhereTheWholeRunDiffers)
{
  Simulation simulation(fedMixture());
  simulation.advanceTo(2.0);
  Steadiness steadiness;
  steadiness.state = SteadyState();
  steadiness.state->from = 41.0;
  steadiness.state->pair = PairSeparation{0, 1, 0.21, {}};
  steadiness.state->separation = Estimate{0.21, 0.02};
  Certainty certainty;
  certainty.separation = SeparationEstimate{{0.292, 0.016}, 0.016, 1.0};
  EXPECT_EQ(
      steadyText(simulation, steadiness, certainty),
      "the separation since the start, 0.292 ± 0.016, is not that of the filled machine: since 41 s it is "
      "0.21 ± 0.02 (steady.separation)");
  certainty.separation->estimate.value = 0.229;
  EXPECT_EQ(steadyText(simulation, steadiness, certainty), "");
  steadiness.state.reset();
  EXPECT_EQ(steadyText(simulation, steadiness, certainty), "");
}

}  // namespace
}  // namespace ratchet_sieve
