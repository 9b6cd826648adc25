// That the version of the physics says what sweeps rely on: one version, the same bits.
#include "ratchet_sieve/core/physics_version.h"

#include <map>

#include <gtest/gtest.h>

#include "core/scenes.h"
#include "ratchet_sieve/core/fnv1a.h"
#include "ratchet_sieve/sweep/case_run.h"

namespace ratchet_sieve
{
namespace
{

/// FNV-1a of the summaries below, by the version of the physics. A change of results adds a line and raises
/// PHYSICS_VERSION; a line that is here stays as it is, for there are results files of its version.
const std::map<std::int64_t, std::uint64_t> SUMMARIES = {{1, 10059554988278898013ull}};

/// One scene for each loop of the engine and each kind of boundary, with all that the physics knows among
/// them.
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
  return {alone, layer, fed, walled};
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
    // Of the run's cost, its program, and what is worked out of the rest.
    for (const char* key : {"wall_time", "version", "plan", "accuracy"})
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
