#include <cmath>

#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/live/run_mirror.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
SceneFrame sceneFrame(const SceneDefinition& scene)
{
  SceneFrame frame;
  frame.yaml = canonicalYaml(scene);
  return frame;
}

ParticleFrame particlesAt(double time)
{
  ParticleFrame frame;
  frame.time = time;
  frame.disks.resize(1);
  return frame;
}

BinFrame binsAt(double time)
{
  BinFrame frame;
  frame.time = time;
  frame.species = {"A", "B"};
  frame.bins.resize(2);
  return frame;
}

BaseFrame baseAt(double time, double inclination = 0.0)
{
  BaseFrame frame;
  frame.time = time;
  frame.base.inclination = inclination;
  return frame;
}

/// A run whose scene was received.
class Seen : public testing::Test
{
protected:
  Seen() { seen.take(sceneFrame(smallMixture())); }

  RunMirror seen;
};

TEST(RunMirror, hasNothingToShowBeforeTheScene)
{
  RunMirror seen;
  seen.take(particlesAt(0.0));
  seen.take(baseAt(0.0));
  EXPECT_FALSE(seen.time());
  seen.take(sceneFrame(smallMixture()));
  EXPECT_EQ(seen.time(), 0.0);
}

TEST_F(Seen, showsTheBaseAtTheTimeOfTheDisks)
{
  EXPECT_FALSE(seen.time());
  for (int k = 0; k < 10; ++k)
    seen.take(baseAt(k, 0.01 * k));
  seen.take(particlesAt(4.0));
  EXPECT_EQ(seen.time(), 4.0);
  EXPECT_TRUE(sameBits(seen.picture().base, baseAt(4.0, 0.04)));
}

/// After a setpoint of the amplitude, which scales the whole orbit.
TEST_F(Seen, carriesAnOrbitOnToTheTimeOfTheDisks)
{
  SceneDefinition scene = smallMixture();
  scene.base.horizontal_amplitude = 0.001;
  scene.base.horizontal_phase = 1.2;
  scene.base.harmonics = {{2, 0.0002, 0.3, 0.0001, 0.9}};
  Simulation simulation(scene);
  simulation.command(Quantity::AMPLITUDE, 0.5 * scene.base.amplitude);
  simulation.advanceTo(2.0);
  const BaseFrame earlier = makeBaseFrame(simulation);
  simulation.advanceTo(2.01);
  const BaseFrame later = makeBaseFrame(simulation);
  seen.take(sceneFrame(scene));
  seen.take(earlier);
  seen.take(particlesAt(2.01));
  EXPECT_EQ(seen.picture().base.time, later.time);
  const DriveState shown = seen.picture().base.base;
  EXPECT_NEAR(shown.phase, later.base.phase, 1e-12);
  EXPECT_NEAR(shown.displacement, later.base.displacement, 1e-15);
  EXPECT_NEAR(shown.velocity, later.base.velocity, 1e-12);
  EXPECT_NEAR(shown.horizontal_displacement, later.base.horizontal_displacement, 1e-15);
  EXPECT_NEAR(shown.horizontal_velocity, later.base.horizontal_velocity, 1e-12);
  EXPECT_NE(shown.horizontal_displacement, earlier.base.horizontal_displacement);
}

TEST_F(Seen, showsTheBaseOfTheSceneWhereNoneWasRecorded)
{
  seen.take(particlesAt(0.0));
  const DriveState shown = seen.picture().base.base;
  const DriveState begun = Simulation(smallMixture()).base();
  EXPECT_EQ(shown.inclination, begun.inclination);
  EXPECT_EQ(shown.amplitude, begun.amplitude);
  EXPECT_EQ(shown.displacement, begun.displacement);
}

TEST_F(Seen, showsTheBaseWhereNoDisksWereRecorded)
{
  seen.take(baseAt(1.0));
  seen.take(baseAt(2.0));
  EXPECT_EQ(seen.time(), 2.0);
  EXPECT_FALSE(seen.picture().particles);
  EXPECT_FALSE(seen.picture().bins);
}

TEST_F(Seen, forgetsWhatIsLaterWhenTimeLeapsBack)
{
  for (const double time : {4.0, 5.0, 6.0})
    seen.take(baseAt(time, 0.3));
  seen.take(particlesAt(6.0));
  seen.take(binsAt(6.0));
  seen.take(baseAt(0.0, 0.1));
  EXPECT_EQ(seen.time(), 0.0);
  EXPECT_EQ(seen.picture().base.base.inclination, 0.1);
  EXPECT_FALSE(seen.picture().particles);
  EXPECT_FALSE(seen.picture().bins);
  seen.take(particlesAt(0.5));
  seen.take(baseAt(1.0, 0.2));
  EXPECT_EQ(seen.time(), 0.5);
  EXPECT_EQ(seen.picture().base.base.inclination, 0.1);
}

TEST_F(Seen, forgetsWhateverTopicLeapsFirst)
{
  seen.take(baseAt(6.0));
  seen.take(particlesAt(6.0));
  seen.take(binsAt(6.0));
  seen.take(particlesAt(0.25));
  EXPECT_EQ(seen.time(), 0.25);
  EXPECT_FALSE(seen.picture().bins);
  seen.take(binsAt(0.25));
  EXPECT_TRUE(seen.picture().bins);
  seen.take(binsAt(0.0));
  EXPECT_FALSE(seen.picture().particles);
}

TEST_F(Seen, leavesOutABaseThatNoneCanBe)
{
  seen.take(baseAt(1.0, 0.1));
  for (const double inclination : {2.0, std::nan("")})
    seen.take(baseAt(2.0, inclination));
  BaseFrame turned = baseAt(2.0);
  turned.base.phase = 1e232;
  seen.take(turned);
  EXPECT_TRUE(sameBits(seen.picture().base, baseAt(1.0, 0.1)));
}

TEST_F(Seen, keepsFewOfThePast)
{
  for (int k = 0; k < 100000; ++k)
    seen.take(baseAt(k, 0.1));
  seen.take(particlesAt(99990.0));
  EXPECT_EQ(seen.picture().base.time, 99990.0);
}

TEST_F(Seen, leavesOutWhatIsNoPartOfTheScene)
{
  ParticleFrame particles = particlesAt(0.0);
  particles.disks[0].species = 2;
  BinFrame bins = binsAt(0.0);
  bins.bins.resize(3);
  seen.take(particles);
  seen.take(bins);
  EXPECT_FALSE(seen.picture().particles);
  EXPECT_FALSE(seen.picture().bins);

  SceneDefinition scene = smallMixture();
  scene.species.resize(3, scene.species[1]);
  scene.species[2].name = "C";
  seen.take(sceneFrame(scene));
  EXPECT_TRUE(seen.picture().particles);
  EXPECT_TRUE(seen.picture().bins);
}

TEST_F(Seen, saysWhatIsWrongWithASceneAndKeepsTheLast)
{
  seen.take(baseAt(0.0));
  SceneFrame bad;
  bad.yaml = "base: {teeth: none}";
  seen.take(bad);
  ASSERT_TRUE(seen.sceneError());
  EXPECT_NE(seen.sceneError()->find("species: missing"), std::string::npos) << *seen.sceneError();
  EXPECT_EQ(seen.picture().scene.base.teeth, smallMixture().base.teeth);
  seen.take(sceneFrame(smallRing()));
  EXPECT_FALSE(seen.sceneError());
  EXPECT_EQ(seen.picture().scene.boundary, Boundary::PERIODIC);
}
}  // namespace
}  // namespace ratchet_sieve
