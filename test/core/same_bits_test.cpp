// However a run is advanced and observed, and wherever it is saved and resumed, it has the same bits.
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "profiles.h"
#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"
#include "state_hash.h"

namespace ratchet_sieve::same_bits  // tests are joined in one source
{
namespace
{

constexpr double MIDDLE = 1.37;  ///< of the run; where it is saved [s]
constexpr double RUN_END = 3.1;  ///< [s]

/// What is done to a simulation at the beginning of each half.
using Command = std::function<void(Simulation&)>;

struct BitsCase
{
  std::string name;
  SceneDefinition scene;
  Command command = [](Simulation&) {};
  double longer = 1.0;  ///< by this factor the times of the run: less where much happens
};

void turnAndPour(Simulation& simulation)
{
  simulation.setSlewRates({0.02, 1.0, 0.001});
  simulation.command(Quantity::INCLINATION, 0.02);
  simulation.command(Quantity::FREQUENCY, 20.0);
  simulation.pour(0, 3);
  simulation.pour(simulation.scene().species.size() - 1, 1);
}

void setGoing(Simulation& simulation)
{
  simulation.command(Quantity::AMPLITUDE, 0.001);
}

/// In the second half the drive needs a finer resolution of time than the scene was set up for.
void speedUp(Simulation& simulation)
{
  simulation.setSlewRates({0.1, 5000.0, 0.01});
  if (simulation.time() < MIDDLE)
    return;
  simulation.command(Quantity::FREQUENCY, 1000.0);
  simulation.command(Quantity::AMPLITUDE, 0.002);
}

SceneDefinition layerOf(Boundary boundary = Boundary::PERIODIC)
{
  SceneDefinition scene = test::mixture(40);
  scene.base.teeth = 8;
  scene.boundary = boundary;
  return scene;
}

SceneDefinition ensemble()
{
  return test::singleParticles(40);
}

SceneDefinition observed(SceneDefinition scene)
{
  scene.settle = 0.5;
  scene.observe = observableNames();
  scene.height_profile = {0.0, 3};
  return scene;
}

SceneDefinition fed()
{
  SceneDefinition scene = observed(layerOf(Boundary::OPEN));
  scene.feed.rate = 60.0;
  scene.contact.contact_duration = 1e-4;
  scene.accuracy.mean_vx = 1e-3;
  return scene;
}

/// Over two compactions.
SceneDefinition fedSieve()
{
  return test::withSizes(test::fedSieve(true));
}

/// As many disks as it, from a list.
SceneDefinition fedFromAList()
{
  SceneDefinition scene = fedSieve();
  scene.feed = {};
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;
  for (std::uint32_t k = 0; k < 4000; ++k)
  {
    const SpeciesDefinition& species = scene.species[k % 2];
    scene.feed.disks.push_back({0.0025 * k, k % 2, (0.8 + 0.1 * (k % 5)) * species.radius, species.mass});
  }
  return scene;
}

SceneDefinition withoutDrive()
{
  SceneDefinition scene = layerOf();
  scene.base.amplitude = 0.0;
  return scene;
}

SceneDefinition collapsing()
{
  SceneDefinition scene = layerOf();
  scene.contact.min_rebound_speed = 0.0;
  scene.contact.on_collapse = CollapseAction::REBOUND;
  scene.contact.collapse_events = 1000;
  return scene;
}

SceneDefinition inFrameOfBase(SceneDefinition scene)
{
  scene.base.drive_frame = DriveFrame::BASE;
  scene.base.inclination = 0.05;
  return scene;
}

SceneDefinition ofTinyDisksAtRest(bool pairs)
{
  SceneDefinition scene = pairs ? test::mixture(10) : test::singleParticles(10);
  scene.base.teeth = 1;
  scene.base.amplitude = 0.0;
  for (SpeciesDefinition& species : scene.species)
    species.radius = 2e-7;
  return scene;
}

/// With cells in nests.
SceneDefinition ofWideSizes(Boundary boundary)
{
  SceneDefinition scene = test::lognormalSizes(150, 0.5);
  scene.species.push_back(test::disksOfSize(12.0, 1));
  scene.base.teeth = 9;
  scene.boundary = boundary;
  return scene;
}

std::vector<BitsCase> bitsCases()
{
  std::vector<BitsCase> all = {
      {"layer", layerOf()},
      {"layer under commands", observed(layerOf()), turnAndPour},
      {"open under commands", observed(layerOf(Boundary::OPEN)), turnAndPour},
      {"walled under commands", observed(layerOf(Boundary::WALLED)), turnAndPour},
      {"fed", fed()},
      {"fed ensemble", test::withoutPairs(fed())},
      {"fed from a list and compacted", fedFromAList(), [](Simulation&) {}, 3.0},
      {"ensemble", observed(ensemble())},
      {"ensemble under commands", observed(ensemble()), turnAndPour},
      {"sizes", observed(test::withSizes(layerOf())), turnAndPour},
      {"ensemble of sizes", test::withSizes(ensemble())},
      {"orbit", test::onAnOrbit(layerOf()), turnAndPour},
      {"orbit of the base", inFrameOfBase(test::onAnOrbit(layerOf())), turnAndPour},
      {"ensemble on an orbit", test::onAnOrbit(ensemble())},
      {"profile", test::onProfile(layerOf(), test::castle())},
      {"ensemble on a profile", test::onProfile(ensemble(), test::castle())},
      {"no drive", withoutDrive(), setGoing},
      {"collapsing", collapsing()},
      {"steps", test::bySteps(layerOf(), 0.0013), turnAndPour},
      {"wide sizes", ofWideSizes(Boundary::PERIODIC), turnAndPour, 0.4},
      {"wide sizes, walled", ofWideSizes(Boundary::WALLED), turnAndPour, 0.4},
      {"finer epoch", ofTinyDisksAtRest(true), speedUp},
      {"finer epoch of an ensemble", ofTinyDisksAtRest(false), speedUp},
  };
  for (const SceneDefinition& scene : test::variantsForSimd())
    all.push_back({"ensemble in SIMD batches", scene});
  all.back().longer = 0.2;
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k].name = std::to_string(k) + "_" + std::regex_replace(all[k].name, std::regex("\\W+"), "_");
  return all;
}

class SameBits : public testing::TestWithParam<BitsCase>
{
protected:
  /// Advances from one of 0, MIDDLE and RUN_END to the next, in strides.
  static void advance(Simulation& simulation, double from, double to, int strides = 1, bool audit = false)
  {
    GetParam().command(simulation);
    for (int k = 1; k <= strides; ++k)
    {
      simulation.advanceTo(GetParam().longer * (k == strides ? to : from + (to - from) * k / strides));
      simulation.disks();
      simulation.observed();
      if (audit)
        simulation.auditOverlaps();
    }
  }

  /// The bits after a whole run.
  static std::string bitsAfter(int strides, std::size_t threads,
                               std::vector<CollisionRecord>* collisions = nullptr)
  {
    Simulation simulation(GetParam().scene);
    simulation.setThreads(threads);
    if (collisions)
    {
      simulation.observeCollisions([&](const CollisionRecord& record) { collisions->push_back(record); });
      simulation.observeExits([](const ExitRecord&) {});
      simulation.observePeriods([](const PeriodRecord&) {});
    }
    advance(simulation, 0.0, MIDDLE, strides);
    advance(simulation, MIDDLE, RUN_END, strides);
    return simulation.saveState();
  }

  /// The disks after a run in which all is observed and overlaps are searched; by events there are none.
  static std::uint64_t disksWhenObserved()
  {
    SceneDefinition scene = GetParam().scene;
    scene.observe = observableNames();
    scene.accuracy.mean_vx = 1e-3;
    Simulation simulation(scene);
    advance(simulation, 0.0, MIDDLE, 23, true);
    advance(simulation, MIDDLE, RUN_END, 23, true);
    if (!simulation.plan().steps)
      test::expectNoOverlap(simulation, 1e-9 * smallestRadius(scene) + 1e-13);
    return test::stateHash(simulation);
  }
};

TEST_P(SameBits, InWhateverStridesOnWhateverThreadsAndLanesWhereItIsResumedAndWhateverIsObserved)
{
  Simulation whole(GetParam().scene);
  advance(whole, 0.0, MIDDLE);
  const std::string saved = whole.saveState();
  advance(whole, MIDDLE, RUN_END);
  ASSERT_GT(whole.collisions().total(), 100u);
  const std::string bits = whole.saveState();

  Simulation resumed(GetParam().scene, saved);
  EXPECT_TRUE(resumed.saveState() == saved);
  advance(resumed, MIDDLE, RUN_END);
  EXPECT_TRUE(resumed.saveState() == bits) << "resumed";
  for (std::size_t i = 0; i < whole.scene().species.size(); ++i)
    EXPECT_EQ(resumed.means()[i].collision_rate, whole.means()[i].collision_rate);
  EXPECT_TRUE(bitsAfter(1, 2) == bits) << "on two threads";
  std::vector<CollisionRecord> told, on_threads;
  EXPECT_TRUE(bitsAfter(97, 1, &told) == bits) << "in strides";
  EXPECT_TRUE(bitsAfter(37, 3, &on_threads) == bits) << "in strides on three threads";
  EXPECT_TRUE(std::equal(told.begin(), told.end(), on_threads.begin(), on_threads.end(), test::areSame));
  EXPECT_EQ(disksWhenObserved(), test::stateHash(whole));
  for (const char* lanes : {"2", "4"})
    if (whole.plan().simd)
    {
      setenv("RATCHET_SIEVE_LANES", lanes, 1);
      EXPECT_TRUE(bitsAfter(1, 1) == bits) << "on " << lanes << " lanes";
    }
  unsetenv("RATCHET_SIEVE_LANES");
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits, testing::ValuesIn(bitsCases()),
                         [](const auto& info) { return info.param.name; });

TEST(SavedState, CutShortOrTooLongIsRefused)
{
  const SceneDefinition scene = layerOf();
  Simulation simulation(scene);
  simulation.advanceTo(0.1);
  const std::string saved = simulation.saveState();
  for (std::size_t size = 0; size < saved.size(); size += 1 + size / 50)
    EXPECT_THROW(Simulation(scene, saved.substr(0, size)), StateError) << size;
  EXPECT_THROW(Simulation(scene, saved + '\0'), StateError);
}

TEST(SavedState, OfAnotherSceneIsRefused)
{
  SceneDefinition other = layerOf();
  other.species.pop_back();
  EXPECT_THROW(Simulation(other, Simulation(layerOf()).saveState()), StateError);
  other = layerOf();
  other.base.profile = test::arc(0.02, 0.006, 5);
  EXPECT_THROW(Simulation(other, Simulation(test::onProfile(layerOf(), test::castle())).saveState()),
               StateError);
}

}  // namespace
}  // namespace ratchet_sieve::same_bits
