#include "ratchet_sieve/recording/proportions.h"

#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "coverage.h"

namespace ratchet_sieve
{
namespace
{

/// R. G. Newcombe, Stat. Med. 17, 857 (1998), Table I, method 3.
TEST(WilsonInterval, IsThatInPrint)
{
  struct
  {
    double part, count, low, high;
  } const printed[] = {
      {81, 263, 0.2553, 0.3662}, {15, 148, 0.0624, 0.1605}, {0, 20, 0.0, 0.1611}, {1, 29, 0.0061, 0.1718}};
  for (const auto& [part, count, low, high] : printed)
  {
    const ProportionInterval found = wilsonInterval(part / count, count, halfWidthOver(0.95, 0));
    EXPECT_NEAR(found.low, low, 5e-5);
    EXPECT_NEAR(found.high, high, 5e-5);
  }
}

/// Disks that leave in groups of one kind each.
Portion portionOf(std::size_t blocks, double each, double share, std::size_t group, std::uint64_t seed)
{
  std::mt19937_64 bits(seed);
  Portion portion;
  for (std::size_t k = 0; k < blocks; ++k)
  {
    const bool belongs = static_cast<double>(bits() >> 11) * 0x1p-53 < share;
    for (std::size_t n = 0; n < group; ++n)
      portion.number.push_back({belongs ? each : 0.0, each});
  }
  portion.mass = portion.number;
  for (BlockSum& block : portion.mass)
    block = {3.0 * block.sum, block.weight + 2.0 * block.sum};
  return portion;
}

TEST(Portions, OfNoneHaveTheIntervalOfTheirCount)
{
  const PortionEstimates found = portionEstimates(portionOf(135, 1.0, 0.0, 1, 1), 1.0, 3.0, 1.0, 0.95);
  EXPECT_EQ(found.number->value, 0.0);
  EXPECT_NEAR(found.number->half_width, 0.0277, 5e-5);  // z^2 / (n + z^2)
  // Three times as heavy: 3 p / (1 + 2 p).
  EXPECT_EQ(found.mass->value, 0.0);
  EXPECT_NEAR(found.mass->half_width, 3.0 * 0.02767 / (1.0 + 2.0 * 0.02767), 5e-5);
  const PortionEstimates all = portionEstimates(portionOf(135, 1.0, 1.0, 1, 1), 1.0, 3.0, 1.0, 0.95);
  EXPECT_EQ(all.number->value, 1.0);
  EXPECT_NEAR(all.number->half_width, 0.0277, 5e-5);
  // Four leave together: as a fourth of them.
  const PortionEstimates grouped = portionEstimates(portionOf(135, 1.0, 0.0, 1, 1), 4.0, 3.0, 1.0, 0.95);
  EXPECT_NEAR(grouped.number->half_width, 3.8415 / (135.0 / 4.0 + 3.8415), 5e-5);
}

TEST(Portions, OfNothingAreUndefined)
{
  const PortionEstimates found = portionEstimates(portionOf(50, 0.0, 0.5, 1, 1), 1.0, 1.0, 1.0, 0.95);
  EXPECT_FALSE(found.number);
  EXPECT_FALSE(found.mass);
}

TEST(Portions, HoldWhateverTheCorrelation)
{
  for (const std::size_t group : {1, 3})
    for (const double share : {0.02, 0.3, 0.95})
    {
      Coverage number, mass;
      for (std::uint64_t seed = 1; seed <= 300; ++seed)
      {
        const PortionEstimates found =
            portionEstimates(portionOf(240 / group, 2.0, share, group, seed), 3.0, 3.0, 1.0, 0.95);
        const double by_mass = 3.0 * share / (1.0 + 2.0 * share);
        number.take(std::abs(found.number->value - share) <= found.number->half_width);
        mass.take(std::abs(found.mass->value - by_mass) <= found.mass->half_width);
      }
      EXPECT_GE(number.share(), 0.95 - number.tolerance(0.95)) << group << " " << share;
      EXPECT_GE(mass.share(), 0.95 - mass.tolerance(0.95)) << group << " " << share;
    }
}

}  // namespace
}  // namespace ratchet_sieve
