#include <cmath>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

/// An action on a simulation while it runs, for a part of the run at a time.
using Advance = void (*)(Simulation&, double from, double to);

void undisturbed(Simulation& simulation, double, double to)
{
  simulation.advanceTo(to);
}

void commanded(Simulation& simulation, double from, double to)
{
  simulation.advanceTo(0.5 * (from + to));
  simulation.command(Quantity::INCLINATION, 0.02 + 0.01 * from);
  simulation.command(Quantity::FREQUENCY, 20.0 + from);
  simulation.pour(0, 3);
  simulation.advanceTo(to);
}

/// A setpoint starts a standing base and is reached before the run is saved.
void setGoing(Simulation& simulation, double from, double to)
{
  if (from == 0.0)
    simulation.command(Quantity::AMPLITUDE, 0.001);
  simulation.advanceTo(to);
}

/// A run that was saved in its middle and resumed has the same final state, bit for bit, as the run without
/// interruption.
void expectTheSameEnd(const SceneDefinition& scene, Advance advance)
{
  constexpr double MIDDLE = 1.37;
  constexpr double END = 3.1;
  Simulation through(scene);
  advance(through, 0.0, MIDDLE);
  const std::string saved = through.saveState();
  Simulation taken_up(scene, saved);
  EXPECT_EQ(taken_up.saveState(), saved);
  advance(through, MIDDLE, END);
  advance(taken_up, MIDDLE, END);
  EXPECT_GT(through.collisions().total(), 100u);
  EXPECT_EQ(test::stateHash(taken_up), test::stateHash(through));
  EXPECT_EQ(taken_up.saveState(), through.saveState());
}

SceneDefinition shortMixture()
{
  SceneDefinition scene = test::mixture(40);
  scene.base.teeth = 5;
  return scene;
}

TEST(SavedState, OfAnOrbitGoesOn)
{
  expectTheSameEnd(test::onAnOrbit(shortMixture()), undisturbed);
  expectTheSameEnd(test::onAnOrbit(shortMixture()), commanded);
  SceneDefinition of_the_base = test::onAnOrbit(shortMixture());
  of_the_base.base.drive_frame = DriveFrame::BASE;
  expectTheSameEnd(of_the_base, commanded);
}

TEST(SavedState, GoesOnBitForBit)
{
  expectTheSameEnd(shortMixture(), undisturbed);
}

TEST(SavedState, OfDisksOfManySizesGoesOnBitForBit)
{
  expectTheSameEnd(test::withSizes(shortMixture()), commanded);
  expectTheSameEnd(test::withSizes(test::singleParticles(20)), undisturbed);
}

TEST(SavedState, OfAnEnsembleGoesOnBitForBit)
{
  expectTheSameEnd(test::singleParticles(20), undisturbed);
}

TEST(SavedState, GoesOnUnderCommandsWhileTheBaseTurns)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED})
  {
    SceneDefinition scene = shortMixture();
    scene.boundary = boundary;
    scene.base.teeth = 10;
    expectTheSameEnd(scene, commanded);
  }
}

TEST(SavedState, GoesOnWhereTheSceneHasNoDriveButTheBaseMoves)
{
  SceneDefinition scene = shortMixture();
  scene.base.amplitude = 0.0;
  expectTheSameEnd(scene, setGoing);
}

TEST(SavedState, GoesOnFeedingAndSettlingWithLosslessContacts)
{
  SceneDefinition scene = shortMixture();
  scene.boundary = Boundary::OPEN;
  scene.feed.rate = 30.0;
  scene.settle = 2.0;
  scene.contact.contact_duration = 1e-4;
  expectTheSameEnd(scene, undisturbed);
}

TEST(SavedState, GoesOnThroughACollapse)
{
  SceneDefinition scene = shortMixture();
  scene.contact.min_rebound_speed = 0.0;
  scene.contact.on_collapse = CollapseAction::REBOUND;
  scene.contact.collapse_events = 1000;
  expectTheSameEnd(scene, undisturbed);
}

TEST(SavedState, GoesOnByStepsUnderCommands)
{
  SceneDefinition scene = shortMixture();
  scene.base.teeth = 10;
  scene.accuracy.method = Method::STEPS;
  scene.accuracy.step = 0.0013;
  expectTheSameEnd(scene, commanded);
}

TEST(SavedState, CutShortOrTooLongIsRefused)
{
  const SceneDefinition scene = shortMixture();
  Simulation simulation(scene);
  simulation.advanceTo(0.1);
  const std::string saved = simulation.saveState();
  for (std::size_t size = 0; size < saved.size(); size += 1 + size / 50)
    EXPECT_THROW(Simulation(scene, saved.substr(0, size)), StateError) << size;
  EXPECT_THROW(Simulation(scene, saved + '\0'), StateError);
}

TEST(SavedState, OfAnotherSceneIsRefused)
{
  Simulation simulation(shortMixture());
  SceneDefinition other = shortMixture();
  other.species.pop_back();
  EXPECT_THROW(Simulation(other, simulation.saveState()), StateError);
}

}  // namespace
}  // namespace ratchet_sieve
