#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "constants.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

/// Lossless disks over a base at rest are a gas in equilibrium, for which statistical mechanics gives exact
/// results (e.g. Landau & Lifshitz, Statistical Physics, 3rd ed., Part 1: section 44, equipartition; section
/// 29, Maxwell's distribution; section 38, the barometric formula). Over teeth, only energy is conserved,
/// because a slope takes up momentum in every direction. Over a flat base the momentum along x is conserved
/// as well, see below.
namespace ratchet_sieve
{
namespace
{

/// Tolerance of the ratio of two mean energies over 10^6 collisions of at least 200 disks. With six seeds it
/// scattered by 0.5 % (rms).
constexpr double OF_MEANS = 0.03;

/// A correct engine fails a Kolmogorov-Smirnov test with this probability after a change of its rounding.
/// Seeds are fixed, so the result is reproducible.
constexpr double P_VALUE = 1e-3;

struct Kind
{
  double mass, radius, inertia_factor;
};

SceneDefinition closed(const Kind& a, const Kind& b, const ContactCoefficients& contact)
{
  SceneDefinition scene = test::mixture(100);
  scene.base.amplitude = 0.0;
  scene.contact.min_rebound_speed = 0.0;
  scene.gravity = GRAVITY;
  const Kind kinds[] = {a, b};
  for (std::size_t i = 0; i < 2; ++i)
  {
    SpeciesDefinition& species = scene.species[i];
    species.mass = kinds[i].mass;
    species.radius = kinds[i].radius;
    species.inertia_factor = kinds[i].inertia_factor;
    species.contact = contact;
  }
  scene.pour.drop_height = 0.05;
  scene.settle = 50.0;
  return scene;
}

constexpr ContactCoefficients SMOOTH{1.0, 0.0, 0.0};
constexpr ContactCoefficients ROUGH{1.0, 1e9, 1.0};  // never slides

TEST(Equilibrium, EverySpeciesHasTheSameTranslationalEnergy)
{
  struct
  {
    Kind a, b;
    double until;
  } const mixtures[] = {{{0.010, 0.001, 0.5}, {0.001, 0.002, 0.5}, 350.0},
                        {{0.001, 0.001, 0.5}, {0.001, 0.003, 0.5}, 200.0},
                        {{0.001, 0.001, 0.5}, {0.010, 0.003, 0.5}, 200.0}};
  for (const auto& mixture : mixtures)
  {
    Simulation simulation(closed(mixture.a, mixture.b, SMOOTH));
    simulation.advanceTo(mixture.until);
    EXPECT_GE(simulation.collisions().total(), 1000000u);
    const auto means = simulation.means();
    EXPECT_NEAR(*means[0].kinetic_translational / *means[1].kinetic_translational, 1.0, OF_MEANS)
        << mixture.a.mass << " kg, " << mixture.b.mass << " kg";
    EXPECT_EQ(*means[0].kinetic_rotational, 0.0) << "nothing turns a smooth disk";
  }
}

TEST(Equilibrium, ARoughDiskTurnsWithHalfTheEnergyOfItsTranslation)
{
  // One rotational degree of freedom to two translational ones, for any inertia.
  const Kind mixtures[][2] = {{{0.010, 0.001, 0.5}, {0.001, 0.002, 0.5}},
                              {{0.001, 0.001, 1.0}, {0.010, 0.003, 0.1}}};
  for (const auto& mixture : mixtures)
  {
    Simulation simulation(closed(mixture[0], mixture[1], ROUGH));
    simulation.advanceTo(250.0);
    EXPECT_GE(simulation.collisions().total(), 1000000u);
    const auto means = simulation.means();
    const double temperature = 0.5 * (*means[0].kinetic_translational + *means[1].kinetic_translational);
    for (const SpeciesMeans& mean : means)
    {
      EXPECT_NEAR(*mean.kinetic_translational / temperature, 1.0, OF_MEANS);
      EXPECT_NEAR(*mean.kinetic_rotational / temperature, 0.5, 0.5 * OF_MEANS);
    }
  }
}

TEST(Equilibrium, OverAFlatBaseTwoDisksShareWhatKeepingTheirMomentumLeaves)
{
  // Smooth disks over a flat base conserve their momentum along x, here 0. For two disks, p_y of each and p_x
  // = p_A = -p_B are free, each with T/2: K_A = T/2 (1 + m_B / M), K_B = T/2 (1 + m_A / M). For 10 : 1 that
  // is 12/11 : 21/11, far from equal.
  SceneDefinition scene = closed({0.010, 0.005, 0.5}, {0.001, 0.010, 0.5}, SMOOTH);
  scene.species[0].count = scene.species[1].count = 0;
  scene.base.tooth_height = 0.0;
  scene.base.teeth = 5;
  scene.initial = {{0, 0.02, 0.06, 0.05, 0.0, 0.0}, {1, 0.05, 0.03, -0.5, 0.0, 0.0}};
  Simulation simulation(scene);
  simulation.advanceTo(60000.0);
  EXPECT_GE(simulation.collisions().disk_disk, 100000u);
  const auto means = simulation.means();
  EXPECT_NEAR(*means[0].kinetic_translational / *means[1].kinetic_translational, 12.0 / 21.0,
              12.0 / 21.0 * OF_MEANS);
}

/// sqrt(n) times the largest distance between the sample's distribution function and the expected one.
double kolmogorovSmirnov(std::vector<double> sample, const std::function<double(double)>& distribution)
{
  std::sort(sample.begin(), sample.end());
  const double n = static_cast<double>(sample.size());
  double farthest = 0.0;
  for (std::size_t k = 0; k < sample.size(); ++k)
  {
    const double below = distribution(sample[k]);
    farthest =
        std::max({farthest, static_cast<double>(k + 1) / n - below, below - static_cast<double>(k) / n});
  }
  return std::sqrt(n) * farthest;
}

/// The probability of a statistic this large or larger, for large n: 2 sum (-1)^(k-1) exp(-2 k^2 x^2)
/// (Kolmogorov 1933; e.g. Marsaglia, Tsang & Wang, J. Stat. Softw. 8(18) (2003), doi:10.18637/jss.v008.i18).
/// For x > 0.3, twenty terms are enough.
double probabilityBeyond(double statistic)
{
  double sum = 0.0;
  for (int k = 1; k <= 20; ++k)
    sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * statistic * statistic);
  return std::min(1.0, sum);
}

/// Correlation of values, about their known mean, with the values one sample later, `stride` entries further
/// on.
double correlation(const std::vector<double>& values, std::size_t stride, double mean)
{
  double products = 0.0, squares = 0.0;
  for (std::size_t k = stride; k < values.size(); ++k)
  {
    products += (values[k] - mean) * (values[k - stride] - mean);
    squares += (values[k] - mean) * (values[k] - mean);
  }
  return products / squares;
}

TEST(Equilibrium, VelocitiesAreMaxwells)
{
  // The variance T/m is taken from the engine's integral of the kinetic energy over the whole run, not from
  // the sample. Its error of 0.3 % changes the distribution by 0.0004, and the finite number N = 200 of disks
  // (an excess kurtosis of -6 / (4 N + 2)) by 0.0002. The test detects 1.95 / sqrt(30000) = 0.011.
  SceneDefinition scene = closed({0.010, 0.001, 0.5}, {0.001, 0.002, 0.5}, SMOOTH);
  Simulation simulation(scene);
  simulation.advanceTo(scene.settle);
  std::vector<double> vx[2], vy[2];
  // A disk has about 36 collisions per second.
  for (int k = 1; k <= 300; ++k)
  {
    simulation.advanceTo(scene.settle + k);
    for (const DiskState& disk : simulation.disks())
    {
      vx[disk.species].push_back(disk.vx);
      vy[disk.species].push_back(disk.vy);
    }
  }
  for (std::size_t species = 0; species < 2; ++species)
  {
    const double mass = scene.species[species].mass;
    const double scale = std::sqrt(2.0 * *simulation.means()[species].kinetic_translational / mass);
    for (const auto& sample : {vx[species], vy[species]})
    {
      ASSERT_EQ(sample.size(), 30000u);
      const auto normal = [&](double v) { return 0.5 * std::erfc(-v / scale); };
      const double statistic = kolmogorovSmirnov(sample, normal);
      EXPECT_GT(probabilityBeyond(statistic), P_VALUE);
      // Samples one second apart are independent: their correlation is 0 within four standard errors.
      EXPECT_NEAR(correlation(sample, 100, 0.0), 0.0, 4.0 / std::sqrt(30000.0));
    }
  }
}

TEST(Equilibrium, DensityFollowsTheBarometricFormula)
{
  // The expected distribution uses no result of the run: a gas of 2 N translational degrees of freedom and N
  // heights in a uniform field has the energy 2 N T above the state with all disks on the base. At the base
  // the disks cover 0.2 % of the plane. Their excluded volume shifts the density there by 0.7 %, and B's mean
  // height by 1 % (second virial coefficient).
  SceneDefinition scene = closed({0.003, 0.001, 0.5}, {0.001, 0.002, 0.5}, SMOOTH);
  scene.base.teeth = 200;
  scene.base.tooth_height = 0.0;
  scene.pour.drop_height = 0.3;
  Simulation simulation(scene);
  double energy = simulation.energy();
  for (const auto& species : scene.species)
    energy -= 100 * species.mass * GRAVITY * species.radius;
  const double temperature = energy / (2.0 * 200.0);
  simulation.advanceTo(scene.settle);
  std::vector<double> heights[2];
  for (int k = 1; k <= 300; ++k)
  {
    simulation.advanceTo(scene.settle + 5.0 * k);
    for (const DiskState& disk : simulation.disks())
      heights[disk.species].push_back(disk.y - scene.species[disk.species].radius);
  }
  EXPECT_GE(simulation.collisions().total(), 1000000u);
  for (std::size_t species = 0; species < 2; ++species)
  {
    const double scale = temperature / (scene.species[species].mass * GRAVITY);
    double mean = 0.0;
    for (const double height : heights[species])
      mean += height / 30000.0;
    EXPECT_NEAR(mean / scale, 1.0, OF_MEANS);
    EXPECT_NEAR(*simulation.means()[species].kinetic_translational / temperature, 1.0, OF_MEANS);
    const auto barometric = [&](double height) { return 1.0 - std::exp(-height / scale); };
    EXPECT_GT(probabilityBeyond(kolmogorovSmirnov(heights[species], barometric)), P_VALUE);
    // Samples five seconds apart have a correlation of 0.05: 30000 samples are equivalent to 27000
    // independent ones.
    EXPECT_LT(correlation(heights[species], 100, mean), 0.1);
  }
}

}  // namespace
}  // namespace ratchet_sieve
