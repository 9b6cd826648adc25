#include "ratchet_sieve/seeking/inclination_search.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace ratchet_sieve
{
namespace
{
/// A model sieve with a known best inclination: each species changes from right to left around its own angle.
struct KnownSieve
{
  double first_turn = 0.2;    ///< where half of A leave on each side [rad]
  double second_turn = 0.1;   ///< the same of B [rad]
  double width = 0.04;        ///< width of the change [rad]
  std::uint64_t disks = 100;  ///< of each species in a trial

  double rightShare(double inclination, double turn) const
  {
    return 1.0 / (1.0 + std::exp((inclination - turn) / width));
  }

  double quality(double inclination) const
  {
    return std::abs(rightShare(inclination, first_turn) - rightShare(inclination, second_turn));
  }

  /// Both change in the same way, so that they separate best in the middle.
  double best() const { return (first_turn + second_turn) / 2.0; }

  /// A trial without noise.
  std::vector<SpeciesBins> expected(double inclination) const
  {
    std::vector<SpeciesBins> bins;
    for (const double turn : {first_turn, second_turn})
    {
      const auto right = static_cast<std::uint64_t>(
          std::llround(rightShare(inclination, turn) * static_cast<double>(disks)));
      bins.push_back({disks - right, right, 0});
    }
    return bins;
  }

  std::vector<SpeciesBins> drawn(double inclination, std::mt19937_64& random) const
  {
    std::vector<SpeciesBins> bins;
    for (const double turn : {first_turn, second_turn})
    {
      const auto right =
          std::binomial_distribution<std::uint64_t>(disks, rightShare(inclination, turn))(random);
      bins.push_back({disks - right, right, 0});
    }
    return bins;
  }
};

/// Bound on the number of trials until it holds, far above the possible maximum.
constexpr int MOST = 2000;

template <typename Trial>
int seek(InclinationSearch& search, const Trial& trial)
{
  int trials = 0;
  while (search.phase() != SearchPhase::HOLD && trials < MOST)
  {
    search.take(trial(search.next()));
    ++trials;
  }
  return trials;
}

TEST(InclinationSearch, findsTheBestFromTheLevel)
{
  const KnownSieve sieve;
  InclinationSearch search({}, 0.0);
  EXPECT_EQ(search.next(), 0.0);
  EXPECT_EQ(search.phase(), SearchPhase::APPROACH);
  const int trials = seek(search, [&](double inclination) { return sieve.expected(inclination); });
  EXPECT_LT(trials, 20);
  EXPECT_EQ(search.next(), search.best());
  EXPECT_NEAR(search.best(), sieve.best(), 0.02);
}

TEST(InclinationSearch, beginsWithinItsRange)
{
  SearchOptions options;
  options.min = 0.1;
  options.max = 0.3;
  EXPECT_EQ(InclinationSearch(options, 0.0).next(), 0.1);
  EXPECT_EQ(InclinationSearch(options, 0.7).next(), 0.3);
}

TEST(InclinationSearch, endsAtTheEndOfTheRangeWhereTheBestIsBeyond)
{
  const KnownSieve sieve;
  SearchOptions options;
  options.min = -0.3;
  options.max = 0.07;
  InclinationSearch search(options, 0.0);
  seek(search, [&](double inclination) { return sieve.expected(inclination); });
  EXPECT_EQ(search.best(), 0.07);
}

TEST(InclinationSearch, holdsWhatItFoundAgainstASingleDrop)
{
  const KnownSieve sieve;
  InclinationSearch search({}, 0.0);
  seek(search, [&](double inclination) { return sieve.expected(inclination); });
  const double held = search.best();
  const std::vector<SpeciesBins> mixed = {{50, 50, 0}, {50, 50, 0}};
  for (int k = 0; k < 5; ++k)
  {
    search.take(mixed);
    EXPECT_EQ(search.phase(), SearchPhase::HOLD);
    search.take(sieve.expected(search.next()));
    EXPECT_EQ(search.phase(), SearchPhase::HOLD);
  }
  EXPECT_EQ(search.next(), held);
  EXPECT_NEAR(search.bestScore().quality, sieve.quality(held), 0.02);
}

TEST(InclinationSearch, seeksAgainWhereTheSieveChanges)
{
  const KnownSieve sieve;
  KnownSieve changed = sieve;
  changed.first_turn = 0.0;
  changed.second_turn = -0.1;
  InclinationSearch search({}, 0.0);
  seek(search, [&](double inclination) { return sieve.expected(inclination); });
  for (int k = 0; k < 2; ++k)
    search.take(changed.expected(search.next()));
  EXPECT_NE(search.phase(), SearchPhase::HOLD);
  EXPECT_EQ(search.restarts(), 1u);
  seek(search, [&](double inclination) { return changed.expected(inclination); });
  EXPECT_NEAR(search.best(), changed.best(), 0.02);
}

TEST(InclinationSearch, forgetsWhatItWasTold)
{
  const KnownSieve sieve;
  InclinationSearch search({}, 0.0);
  seek(search, [&](double inclination) { return sieve.expected(inclination); });
  const double held = search.next();
  search.restart();
  EXPECT_EQ(search.next(), held);
  EXPECT_FALSE(search.bestScore().defined);
  EXPECT_EQ(search.phase(), SearchPhase::APPROACH);
}

KnownSieve anySieve()
{
  KnownSieve sieve;
  sieve.first_turn = *rc::gen::inRange(-350, 350) * 1e-3;
  sieve.second_turn = std::clamp(sieve.first_turn + *rc::gen::inRange(-250, 250) * 1e-3, -0.4, 0.4);
  sieve.width = *rc::gen::inRange(10, 100) * 1e-3;
  return sieve;
}

double anyInclination()
{
  return *rc::gen::inRange(-500, 501) * 1e-3;
}

RC_GTEST_PROP(InclinationSearch, findsTheBestFromAnywhere, ())
{
  KnownSieve sieve = anySieve();
  sieve.disks = 100000000;  // so many that there is no noise
  RC_PRE(sieve.quality(sieve.best()) > 0.05);
  const SearchOptions options;
  InclinationSearch search(options, anyInclination());
  const int trials = seek(search, [&](double inclination) { return sieve.expected(inclination); });
  RC_ASSERT(trials < 60);
  // Its last comparisons are less than two resolutions away; Q decreases equally on both sides of the best.
  RC_ASSERT(std::abs(search.best() - sieve.best()) <= options.resolution);
}

/// With noise nothing is certain, but a bad choice is rare: the mean loss over many sieves is small.
TEST(InclinationSearch, findsTheBestInNoise)
{
  std::mt19937_64 random(1);
  double loss = 0.0;
  double worst = 0.0;
  constexpr int SIEVES = 5000;
  for (int k = 0; k < SIEVES; ++k)
  {
    KnownSieve sieve;
    sieve.second_turn = std::uniform_real_distribution<>(-0.2, 0.2)(random);
    sieve.first_turn = sieve.second_turn + std::uniform_real_distribution<>(0.05, 0.2)(random);
    sieve.width = std::uniform_real_distribution<>(0.02, 0.06)(random);
    InclinationSearch search({}, std::uniform_real_distribution<>(-0.5, 0.5)(random));
    const int trials = seek(search, [&](double inclination) { return sieve.drawn(inclination, random); });
    ASSERT_LT(trials, MOST);
    const double lost = sieve.quality(sieve.best()) - sieve.quality(search.best());
    loss += lost / SIEVES;
    worst = std::max(worst, lost);
  }
  EXPECT_LT(loss, 0.015);  // without repeated trials: 0.018
  EXPECT_LT(worst, 0.3);
}

/// For any input, it stays in its range and terminates.
RC_GTEST_PROP(InclinationSearch, endsWhateverItIsTold, ())
{
  SearchOptions options;
  options.min = -*rc::gen::inRange(0, 500) * 1e-3;
  options.max = *rc::gen::inRange(1, 500) * 1e-3;
  options.step = *rc::gen::inRange(20, 300) * 1e-3;
  options.most_trials = *rc::gen::inRange(1, 5);
  options.confidence = *rc::gen::inRange(0, 4);
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  InclinationSearch search(options, anyInclination());
  const auto some = [&] { return std::uniform_int_distribution<std::uint64_t>(0, 40)(random); };
  const int trials = seek(search,
                          [&](double inclination)
                          {
                            RC_ASSERT(inclination >= options.min && inclination <= options.max);
                            return std::vector<SpeciesBins>{{some(), some(), 0}, {some(), some(), 0}};
                          });
  RC_ASSERT(trials < MOST);
}

/// Mirror symmetry: for the mirrored sieve the search gives the mirrored inclinations.
RC_GTEST_PROP(InclinationSearch, knowsNoLeftFromRight, ())
{
  KnownSieve sieve = anySieve();
  sieve.disks = 100000000;
  const double start = anyInclination() + 1e-4;  // no two inclinations are equally good
  InclinationSearch search({}, start);
  InclinationSearch mirrored({}, -start);
  for (int k = 0; k < 60; ++k)
  {
    RC_ASSERT(search.next() == -mirrored.next());
    std::vector<SpeciesBins> bins = sieve.expected(search.next());
    search.take(bins);
    for (SpeciesBins& b : bins)
      std::swap(b.left, b.right);
    mirrored.take(bins);
  }
}
}  // namespace
}  // namespace ratchet_sieve
