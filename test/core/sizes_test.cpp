#include "ratchet_sieve/core/sizes.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "model/random.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

SpeciesDefinition speciesWith(const SizeDefinition& size)
{
  SpeciesDefinition species = test::smallDisk(0);
  species.size = size;
  return species;
}

std::vector<double> drawnRadii(const SpeciesDefinition& species, std::size_t count)
{
  const Sizes sizes(species);
  Random random(5);
  std::vector<double> radii;
  while (radii.size() < count)
    radii.push_back(sizes.draw([&] { return random.uniform(); }));
  std::sort(radii.begin(), radii.end());
  return radii;
}

double phi(double z)
{
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

/// Of a normal distribution cut at 3 standard deviations.
double cutPhi(double z)
{
  return (phi(std::clamp(z, -3.0, 3.0)) - phi(-3.0)) / (phi(3.0) - phi(-3.0));
}

/// Kolmogorov-Smirnov: one sample in a hundred exceeds 1.63 / sqrt(n); the seed is fixed.
void expectDistribution(const SpeciesDefinition& species, const std::function<double(double)>& cumulative)
{
  constexpr std::size_t COUNT = 20000;
  const std::vector<double> radii = drawnRadii(species, COUNT);
  double distance = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < COUNT; ++i)
  {
    distance = std::max(distance, std::abs(cumulative(radii[i]) - (static_cast<double>(i) + 0.5) / COUNT));
    sum += radii[i];
    squares += radii[i] * radii[i];
  }
  EXPECT_LT(distance, 1.63 / std::sqrt(COUNT));
  const Sizes sizes(species);
  EXPECT_GE(radii.front(), sizes.smallest());
  EXPECT_LE(radii.back(), sizes.largest());
  const double mean = sum / COUNT;
  const double deviation = std::sqrt(squares / COUNT - mean * mean);
  EXPECT_NEAR(sizes.meanRadius(), mean, 4.0 * deviation / std::sqrt(COUNT));
  const double mass = meanMass(species);
  double masses = 0.0;
  double mass_squares = 0.0;
  for (const double radius : radii)
  {
    masses += species.massOf(radius);
    mass_squares += species.massOf(radius) * species.massOf(radius);
  }
  EXPECT_NEAR(mass, masses / COUNT, 4.0 * std::sqrt(mass_squares) / COUNT);
  EXPECT_NEAR(sizes.meanSquare(), squares / COUNT, 8.0 * sizes.largest() * deviation / std::sqrt(COUNT));
}

TEST(Sizes, AreEqualByDefaultAndDrawNothing)
{
  const SpeciesDefinition species = test::smallDisk(1);
  const Sizes sizes(species);
  EXPECT_EQ(sizes.smallest(), species.radius);
  EXPECT_EQ(sizes.largest(), species.radius);
  EXPECT_EQ(sizes.meanRadius(), species.radius);
  EXPECT_EQ(sizes.draw([]() -> double { throw std::logic_error("drawn"); }), species.radius);
  EXPECT_EQ(species.massOf(species.radius), species.mass);
}

TEST(Sizes, AreOfTheirDistributionWithinItsEnds)
{
  struct
  {
    SizeDistribution distribution;
    double spread;
    double smallest, largest;
    double (*cumulative)(double radius);
  } const cases[] = {
      {SizeDistribution::UNIFORM, 0.4, 0.0006, 0.0014, [](double r) { return (r / 0.001 - 0.6) / 0.8; }},
      {SizeDistribution::NORMAL, 0.2, 0.0004, 0.0016,
       [](double r) { return cutPhi((r / 0.001 - 1.0) / 0.2); }},
      {SizeDistribution::LOGNORMAL, 0.5, 0.001 * std::exp(-1.5), 0.001 * std::exp(1.5),
       [](double r) { return cutPhi(std::log(r / 0.001) / 0.5); }}};
  for (const auto& one : cases)
  {
    const SpeciesDefinition species = speciesWith({one.distribution, one.spread, 3.0, {}, {}, {}});
    expectDistribution(species, one.cumulative);
    EXPECT_NEAR(Sizes(species).smallest(), one.smallest, 1e-16);
    EXPECT_NEAR(Sizes(species).largest(), one.largest, 1e-16);
  }
}

/// The cumulative share of a table, piecewise linear in the radius.
double interpolated(const SizeDefinition& size, double radius)
{
  double sum = 0.0;
  double below = 0.0;
  for (std::size_t k = 0; k < size.radii.size(); ++k)
  {
    sum += size.weights[k];
    const double from = size.radii[k > 0 ? k - 1 : 0];
    below += size.weights[k] * (radius >= size.radii[k] ? 1.0
                                : radius > from         ? (radius - from) / (size.radii[k] - from)
                                                        : 0.0);
  }
  return below / sum;
}

TEST(Sizes, FollowATableByNumber)
{
  const SizeDefinition size{
      SizeDistribution::TABLE, 0.0, 3.0, {0.0004, 0.001, 0.002, 0.005}, {0.0, 2.0, 5.0, 1.0},
      SizeShare::NUMBER};
  expectDistribution(speciesWith(size), [&](double r) { return interpolated(size, r); });
}

/// The masses of many disks add up to the table's cumulative mass.
TEST(Sizes, FollowATableByMass)
{
  for (const double exponent : {0.5, 1.0, 2.0, 3.0})
  {
    const SizeDefinition size{
        SizeDistribution::TABLE, 0.0, exponent, {0.0008, 0.001, 0.002, 0.003}, {0.5, 2.0, 5.0, 1.0},
        SizeShare::MASS};
    const SpeciesDefinition species = speciesWith(size);
    const std::vector<double> radii = drawnRadii(species, 100000);
    double total = 0.0;
    double square = 0.0;
    for (const double radius : radii)
    {
      total += species.massOf(radius);
      square += species.massOf(radius) * species.massOf(radius);
    }
    const double error = std::sqrt(square) / total;  // of a share, at most
    double sum = 0.0;
    double distance = 0.0;
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      sum += species.massOf(radii[i]);
      if (i + 1 == radii.size() || radii[i + 1] > radii[i])
        distance = std::max(distance, std::abs(sum / total - interpolated(size, radii[i])));
    }
    EXPECT_LT(distance, 1.63 * error) << exponent;
  }
}

/// Most are small: with p = 2 the mean is r_1 ln(R) / (1 - 1/R) of radii from r_1 to R r_1.
TEST(Sizes, OfAWideTableByMassHaveTheirMeanAndAreDrawnAtOnce)
{
  for (const double ratio : {10.0, 1e3, 1e5})
  {
    const SizeDefinition size{SizeDistribution::TABLE, 0.0,        2.0,
                              {0.001, 0.001 * ratio},  {0.0, 3.0}, SizeShare::MASS};
    const Sizes sizes(speciesWith(size));
    const double mean = 0.001 * std::log(ratio) / (1.0 - 1.0 / ratio);
    EXPECT_NEAR(sizes.meanRadius(), mean, 1e-5 * mean) << ratio;
    Random random(7);
    int numbers = 0;
    int small = 0;
    for (int draw = 0; draw < 2000; ++draw)
      small += sizes.draw(
                   [&]
                   {
                     ++numbers;
                     return random.uniform();
                   }) < 0.002;
    EXPECT_LT(numbers, 8 * 2000);
    // Half of those between r_1 and infinity; 4 standard deviations.
    EXPECT_NEAR(small / 2000.0, 0.5 / (1.0 - 1.0 / ratio), 4.0 * std::sqrt(0.25 / 2000.0)) << ratio;
  }
}

TEST(Sizes, MassGrowsWithItsExponent)
{
  for (const double exponent : {0.0, 1.0, 2.0, 2.5, 3.0, 7.3})
  {
    SpeciesDefinition species = test::smallDisk(1);
    species.size.mass_exponent = exponent;
    for (const double ratio : {0.02, 0.5, 1.0, 1.7, 50.0})
    {
      const double expected = species.mass * std::pow(ratio, exponent);
      EXPECT_NEAR(species.massOf(ratio * species.radius), expected, 1e-12 * expected);
    }
  }
}

/// The radii of a scene are drawn from its seed, for poured and for fed disks.
TEST(Sizes, AreDrawnForEveryDiskOfAScene)
{
  SceneDefinition scene = test::withSizes(test::mixture(200));
  scene.feed.rate = 100.0;
  Simulation one(scene);
  one.advanceTo(1.0);
  const std::vector<DiskState> disks = one.disks();
  EXPECT_NEAR(static_cast<double>(disks.size()), 400.0 + 100.0, 40.0);  // 100 are fed, by a Poisson process
  for (std::size_t k = 0; k < disks.size(); ++k)
  {
    const Sizes sizes(scene.species[disks[k].species]);
    EXPECT_GE(disks[k].radius, sizes.smallest());
    EXPECT_LE(disks[k].radius, sizes.largest());
    EXPECT_TRUE(k == 0 || disks[k].radius != disks[k - 1].radius || disks[k].species == 1u);
  }
  scene.seed = 2;
  EXPECT_NE(Simulation(scene).disks()[0].radius,
            Simulation(test::withSizes(test::mixture(200))).disks()[0].radius);
}

/// The species without sizes is poured from the same random numbers as before.
TEST(Sizes, OfNoSpreadChangeNothing)
{
  SceneDefinition scene = test::mixture(20);
  Simulation plain(scene);
  scene.species[0].size = {SizeDistribution::LOGNORMAL, 0.0, 2.0, {}, {}, {}};
  Simulation spread(scene);
  plain.advanceTo(0.5);
  spread.advanceTo(0.5);
  EXPECT_EQ(plain.saveState(), spread.saveState());
}

/// <V_x> and energies of a species weigh its disks by their masses.
TEST(Sizes, EnergyIsThatOfEveryDisksMass)
{
  SceneDefinition scene = test::withSizes(test::mixture(50));
  scene.gravity = 0.0;
  scene.pour.speed = 2.0;
  scene.base.amplitude = 0.0;
  Simulation simulation(scene);
  double energy = 0.0;
  for (const DiskState& disk : simulation.disks())
    energy += 0.5 * scene.species[disk.species].massOf(disk.radius) * disk.vy * disk.vy;
  EXPECT_NEAR(simulation.energy(), energy, 1e-12 * energy);
  // Before the first contact the means are those of the flight.
  simulation.advanceTo(1e-3);
  ASSERT_EQ(simulation.collisions().total(), 0u);
  double means = 0.0;
  for (const SpeciesMeans& species : simulation.means())
    means += 50.0 * *species.kinetic_translational;
  EXPECT_NEAR(means, energy, 1e-12 * energy);
}

}  // namespace
}  // namespace ratchet_sieve
