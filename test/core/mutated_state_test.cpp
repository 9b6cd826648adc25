// Saved states with corrupted values are either refused with one line or run normally; none crashes the
// program.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// A few hundred by default; the environment can request more for a longer run.
int mutations()
{
  const char* asked_for = std::getenv("RATCHET_SIEVE_MUTATIONS");
  return asked_for != nullptr ? std::atoi(asked_for) : 500;
}

/// Replaces eight bytes at a random position by a special number, or four by the smallest integer, or one by
/// another byte.
std::string mutated(std::string state, std::mt19937_64& random)
{
  static const double VALUES[] = {0.0,
                                  -1.0,
                                  1e-300,
                                  1e3,
                                  -1e3,
                                  1e18,
                                  -1e18,
                                  1e300,
                                  -1e300,
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
  const std::size_t place = random() % (state.size() - sizeof(double));
  static const std::int32_t LEAST = std::numeric_limits<std::int32_t>::min();
  switch (random() % 3)
  {
    case 0:
      std::memcpy(&state[place], &VALUES[random() % std::size(VALUES)], sizeof(double));
      break;
    case 1:
      std::memcpy(&state[place], &LEAST, sizeof LEAST);
      break;
    default:
      state[place] = static_cast<char>(random());
  }
  return state;
}

/// With a low limit for collapses, which take long otherwise.
SceneDefinition quickToCollapse(SceneDefinition scene)
{
  scene.base.teeth = 5;
  scene.contact.collapse_events = 1000;
  return scene;
}

/// @return number of mutated states that were refused
int refusals(const SceneDefinition& scene)
{
  Simulation simulation(scene);
  simulation.advanceTo(0.6);
  simulation.command(Quantity::INCLINATION, 0.1);
  simulation.advanceTo(0.7);
  const std::string saved = simulation.saveState();
  std::mt19937_64 random(1);
  int refused = 0;
  for (int k = 0; k < mutations(); ++k)
    try
    {
      Simulation resumed(scene, mutated(saved, random));
      resumed.auditOverlaps();
      resumed.advanceTo(resumed.time() + 0.02);
      resumed.auditOverlaps();
      resumed.observed();
    }
    catch (const StateError& error)
    {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    catch (const StallError&)
    {
    }
  return refused;
}

TEST(MutatedState, OfALayerIsRefusedOrGoesOn)
{
  EXPECT_GT(refusals(quickToCollapse(test::mixture(30))), 0);
  EXPECT_GT(refusals(quickToCollapse(test::openMixture(10))), 0);
}

TEST(MutatedState, OfDisksOfManySizesIsRefusedOrGoesOn)
{
  SceneDefinition scene = quickToCollapse(test::withSizes(test::mixture(20)));
  scene.contact.collapse_events = 20000;
  EXPECT_GT(refusals(scene), 0);
}

TEST(MutatedState, OfNestedCellsIsRefusedOrGoesOn)
{
  EXPECT_GT(refusals(quickToCollapse(test::oneLarge(60, 8.0))), 0);
}

TEST(MutatedState, OfAnEnsembleIsRefusedOrGoesOn)
{
  EXPECT_GT(refusals(quickToCollapse(test::singleParticles(30))), 0);
}

TEST(MutatedState, OfAnObservedMachineIsRefusedOrGoesOn)
{
  SceneDefinition scene = quickToCollapse(test::openMixture(5));
  scene.observe = observableNames();
  scene.height_profile = {0.01, 2};
  EXPECT_GT(refusals(scene), 0);
}

TEST(MutatedState, OfAStepLoopIsRefusedOrGoesOn)
{
  SceneDefinition scene = quickToCollapse(test::mixture(30));
  scene.accuracy.method = Method::STEPS;
  scene.accuracy.step = 0.001;
  EXPECT_GT(refusals(scene), 0);
}

}  // namespace
}  // namespace ratchet_sieve
