#include "ratchet_sieve/statistics/block_averages.h"

#include <cmath>

#include <gtest/gtest.h>

#include "model/random.h"

namespace ratchet_sieve
{
namespace
{

/// The error estimated by BlockAverages over the true one, averaged over many series of x[k] = memory x[k-1]
/// + noise. For large n, the mean of n members has the variance s^2 / n (1 + memory) / (1 - memory), s^2 =
/// var(noise) / (1 - memory^2).
double foundOverTrue(double memory, int length)
{
  Random random(11);
  const int series = 200;
  double sum = 0.0;
  for (int k = 0; k < series; ++k)
  {
    BlockAverages blocks;
    double value = 0.0;
    for (int i = 0; i < length; ++i)
    {
      value = memory * value + random.uniform() - 0.5;
      blocks.add(3.0 + value, 1.0);
    }
    sum += *blocks.standardError();
  }
  const double variance = 1.0 / 12.0 / (1.0 - memory * memory) * (1.0 + memory) / (1.0 - memory) / length;
  return sum / series / std::sqrt(variance);
}

TEST(BlockAverages, FindTheErrorOfACorrelatedSeries)
{
  // An error of independent samples would be too small by a factor of up to 4.4.
  EXPECT_NEAR(foundOverTrue(0.0, 4000), 1.0, 0.1);
  EXPECT_NEAR(foundOverTrue(0.5, 4000), 1.0, 0.1);
  EXPECT_NEAR(foundOverTrue(0.9, 4000), 1.0, 0.1);
  EXPECT_NEAR(foundOverTrue(0.5, 100), 1.0, 0.1);
}

/// A disk that jiggles about a place: however long the series is, its displacement is that between the two
/// ends. The error of independent samples would be up to 20 times as large.
TEST(BlockAverages, FindTheErrorOfABoundedSum)
{
  for (const double memory : {0.0, 0.8})
    for (const int length : {300, 4000})
    {
      Random random(12);
      const int series = 200;
      double found = 0.0, truth = 0.0;
      for (int k = 0; k < series; ++k)
      {
        BlockAverages blocks;
        double place = 0.0, first = 0.0;
        for (int i = -50; i <= length; ++i)
        {
          const double before = place;
          place = memory * place + random.uniform() - 0.5;
          if (i > 0)
            blocks.add(place - before, 1.0);
          else
            first = place;
        }
        found += std::pow(*blocks.standardError() * length, 2);
        truth += std::pow(place - first, 2);
      }
      EXPECT_GT(found / truth, 0.8) << memory << " " << length;
      EXPECT_LT(found / truth, 1.7) << memory << " " << length;
    }
}

TEST(BlockAverages, TooShortASeriesSaysNothing)
{
  BlockAverages blocks;
  for (int i = 0; i < 47; ++i)
    blocks.add(i % 7, 1.0);
  EXPECT_FALSE(blocks.standardError());
  blocks.add(0.0, 1.0);
  EXPECT_TRUE(blocks.standardError());

  BlockAverages drifting;
  for (int i = 0; i < 200; ++i)
    drifting.add(i, 1.0);
  EXPECT_FALSE(drifting.standardError());
}

TEST(BlockAverages, SteadyMotionHasNoError)
{
  BlockAverages blocks;
  for (int i = 0; i < 5000; ++i)
    blocks.add(0.5, 0.25);
  EXPECT_NEAR(*blocks.standardError(), 0.0, 1e-15);
}

}  // namespace
}  // namespace ratchet_sieve
