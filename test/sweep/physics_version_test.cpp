// The guarantee of the physics version that sweeps rely on: one version, the same bits.
#include "ratchet_sieve/core/physics_version.h"

#include <map>

#include <gtest/gtest.h>

#include "core/scenes.h"
#include "ratchet_sieve/scene/fnv1a.h"
#include "ratchet_sieve/sweep/case.h"

namespace ratchet_sieve
{
namespace
{

/// FNV-1a of the summaries below, by physics version. A change of results adds a line and increases
/// PHYSICS_VERSION; existing lines never change, because results files of their version exist.
const std::map<std::int64_t, std::uint64_t> SUMMARIES = {
    {1, 10059554988278898013ull}, {2, 3678576686467559268ull}, {3, 16194533993657830448ull},
    {4, 16194533993657830448ull}, {5, 6294015590571413587ull}, {6, 8360195563167242579ull}};

/// One scene for each loop of the engine and each kind of boundary; together they use all parts of the
/// physics.
std::vector<SceneDefinition> scenes()
{
  SceneDefinition alone = test::singleParticles(50);
  alone.duration = 10.0;
  SceneDefinition layer = test::mixture(60);
  layer.base.teeth = 5;
  layer.base.inclination = 0.052;
  layer.duration = 2.0;
  SceneDefinition fed = test::onAnOrbit(test::openMixture(20));
  fed.base.inclination = 0.1;
  fed.feed.rate = 10.0;
  fed.contact.restitution_speed = 0.5;
  fed.settle = 0.5;
  fed.duration = 3.0;
  SceneDefinition walled = test::mixture(20);
  walled.boundary = Boundary::WALLED;
  walled.contact.contact_duration = 1e-4;
  walled.duration = 2.0;
  const auto by_steps = [](SceneDefinition scene)
  {
    scene.accuracy.method = Method::STEPS;
    scene.accuracy.step = 0.001;
    return scene;
  };
  return {alone, layer, fed, walled, by_steps(layer), by_steps(fed)};
}

std::string summaries()
{
  std::string text;
  for (const SceneDefinition& scene : scenes())
  {
    SweepCase next;
    next.scene = scene;
    const std::optional<CaseResult> result = runCase(next, {});
    EXPECT_EQ(result->error, "");
    nlohmann::ordered_json summary = result->summary;
    // Not part of the physics: cost, program, derived values and texts.
    for (const char* key :
         {"wall_time", "version", "plan", "accuracy", "steady", "steady_reason", "steady_needs", "warnings"})
      EXPECT_EQ(summary.erase(key), 1u) << key;
    text += summary.dump() + '\n';
  }
  return text;
}

TEST(PhysicsVersion, IsAnotherWhereResultsAre)
{
  EXPECT_EQ(SUMMARIES.rbegin()->first, PHYSICS_VERSION);
  const std::string text = summaries();
  EXPECT_EQ(SUMMARIES.at(PHYSICS_VERSION), fnv1a(text))
      << "raise PHYSICS_VERSION and add a line to SUMMARIES; the summaries are now\n"
      << text;
}

}  // namespace
}  // namespace ratchet_sieve
