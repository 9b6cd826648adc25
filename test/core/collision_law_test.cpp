#include "ratchet_sieve/core/collision_law.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{

/// A disk of 2 kg against the base: m_n = 2 kg, m_t = 2 / (1 + 1 / alpha) = 2/3 kg for alpha = 1/2.
SpeciesDefinition disk(double mass, double alpha = 0.5)
{
  SpeciesDefinition species;
  species.mass = mass;
  species.radius = 0.1;
  species.inertia_factor = alpha;
  return species;
}

TEST(ContactMasses, BaseIsInfinite)
{
  const ContactMasses masses = contactMasses(disk(2.0), nullptr);
  EXPECT_DOUBLE_EQ(masses.normal, 2.0);
  EXPECT_DOUBLE_EQ(masses.tangential, 2.0 / 3.0);
}

TEST(ContactMasses, PairOfDifferentMassesAndInertias)
{
  const SpeciesDefinition other = disk(3.0, 0.4);
  const ContactMasses masses = contactMasses(disk(2.0), &other);
  EXPECT_DOUBLE_EQ(masses.normal, 1.2);                          // 1 / (1/2 + 1/3)
  EXPECT_DOUBLE_EQ(masses.tangential, 1.0 / (1.5 + 7.0 / 6.0));  // 1/2 + 1/3 + 2/2 + 2.5/3
}

struct LawCase
{
  const char* branch;
  ContactCoefficients coefficients;
  double v_n, v_t, v_min;
  double j_n, j_t;
};

/// Worked out by hand for m_n = 2 kg, m_t = 2/3 kg.
const LawCase CASES[] = {
    {"smooth, elastic", {1.0, 0.0, 0.0}, -3.0, 5.0, 0.0, 12.0, 0.0},
    {"smooth, inelastic", {0.5, 0.0, 0.0}, -3.0, 5.0, 0.0, 9.0, 0.0},
    {"sliding: mu J_n = 0.9 < 3.33", {0.5, 0.1, 0.0}, -3.0, 5.0, 0.0, 9.0, -0.9},
    {"sliding the other way", {0.5, 0.1, 0.0}, -3.0, -5.0, 0.0, 9.0, 0.9},
    {"sticking: 2/3 * 0.3 = 0.2 < 0.9", {0.5, 0.1, 0.0}, -3.0, 0.3, 0.0, 9.0, -0.2},
    {"sticking with beta: 1.4 * 0.2", {0.5, 0.1, 0.4}, -3.0, 0.3, 0.0, 9.0, -0.28},
    {"perfectly rough", {1.0, 1000.0, 1.0}, -3.0, 3.0, 0.0, 12.0, -4.0},
    {"beta = -1 is smooth whatever mu", {0.5, 10.0, -1.0}, -3.0, 5.0, 0.0, 9.0, 0.0},
    {"rebound floor: 0.5 * 0.04 < 0.05", {0.5, 0.0, 0.0}, -0.04, 0.0, 0.05, 0.18, 0.0},
    {"above the floor", {0.5, 0.0, 0.0}, -0.2, 0.0, 0.05, 0.6, 0.0},
    {"friction on the floored impulse", {0.5, 0.1, 0.0}, -0.04, 5.0, 0.05, 0.18, -0.018},
    {"e = 0 with a floor", {0.0, 0.0, 0.0}, -1.0, 0.0, 0.05, 2.1, 0.0},
    {"e = 0 without", {0.0, 0.0, 0.0}, -1.0, 0.0, 0.0, 2.0, 0.0},
    {"lossless", LOSSLESS, -0.3, 7.0, 0.0, 1.2, 0.0},
};

TEST(Collide, EveryBranchAgainstNumbersWorkedOutByHand)
{
  const ContactMasses masses{2.0, 2.0 / 3.0};
  for (const LawCase& c : CASES)
  {
    const Impulse impulse = collide(c.coefficients, masses, c.v_n, c.v_t, c.v_min);
    EXPECT_NEAR(impulse.normal, c.j_n, 1e-14) << c.branch;
    EXPECT_NEAR(impulse.tangential, c.j_t, 1e-14) << c.branch;
  }
}

TEST(ContactBetween, PairsOwnCoefficientsOrElseTheMean)
{
  SceneDefinition scene;
  scene.species = {disk(1.0), disk(2.0)};
  scene.species[0].contact = {0.6, 0.1, 0.4};
  scene.species[1].contact = {0.8, 0.3, 0.0};
  EXPECT_DOUBLE_EQ(contactBetween(scene, 0, 1).restitution, 0.7);
  EXPECT_DOUBLE_EQ(contactBetween(scene, 1, 0).friction, 0.2);
  EXPECT_DOUBLE_EQ(contactBetween(scene, 0, 0).tangential_restitution, 0.4);
  scene.pairs = {{1, 0, {0.9, 0.0, -1.0}}};
  EXPECT_EQ(contactBetween(scene, 0, 1).restitution, 0.9);
  EXPECT_EQ(contactBetween(scene, 1, 0).tangential_restitution, -1.0);
  EXPECT_EQ(contactBetween(scene, 1, 1).restitution, 0.8);
}

}  // namespace
}  // namespace ratchet_sieve
