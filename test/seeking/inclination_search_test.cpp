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
  double mixed = 0.0;         ///< share of both that leaves by chance, half on each side
  double fastest = 0.0;       ///< where most disks leave per time [rad]
  double fast_width = 0.0;    ///< width of that maximum [rad]; 0: as many leave everywhere
  std::uint64_t disks = 100;  ///< of each species in a trial

  double rightShare(double inclination, double turn) const
  {
    return 0.5 * mixed + (1.0 - mixed) / (1.0 + std::exp((inclination - turn) / width));
  }

  double quality(double inclination) const
  {
    return std::abs(rightShare(inclination, first_turn) - rightShare(inclination, second_turn));
  }

  /// Both change in the same way, so that they separate best in the middle.
  double best() const { return (first_turn + second_turn) / 2.0; }

  /// A trial without noise.
  Outflow expected(double inclination) const
  {
    Outflow outflow = empty();
    for (const double turn : {first_turn, second_turn})
    {
      const auto right = static_cast<std::uint64_t>(
          std::llround(rightShare(inclination, turn) * static_cast<double>(disks)));
      outflow.bins.push_back({disks - right, right, 0});
    }
    if (fast_width > 0.0)
      outflow.duration *= std::exp(std::pow((inclination - fastest) / fast_width, 2));
    return outflow;
  }

  Outflow drawn(double inclination, std::mt19937_64& random) const
  {
    Outflow outflow = empty();
    for (const double turn : {first_turn, second_turn})
    {
      const auto right =
          std::binomial_distribution<std::uint64_t>(disks, rightShare(inclination, turn))(random);
      outflow.bins.push_back({disks - right, right, 0});
    }
    return outflow;
  }

  static Outflow empty() { return {{"A", "B"}, {}, 10.0}; }
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

/// The best inclination by comparing many, without noise [rad].
double bestOf(const Goal& goal, const KnownSieve& sieve, const SearchOptions& options)
{
  double best = options.min;
  for (double inclination = options.min; inclination <= options.max; inclination += 1e-3)
    if (measured(goal, sieve.expected(inclination)).value > measured(goal, sieve.expected(best)).value)
      best = inclination;
  return best;
}

TEST(InclinationSearch, findsTheBestByWhatItIsAskedFor)
{
  KnownSieve sieve;
  sieve.mixed = 0.1;
  sieve.fastest = 0.26;
  sieve.fast_width = 0.1;
  sieve.disks = 100000000;
  SearchOptions options;
  for (const char* text : {"throughput", "flow:A:left", "flow:B:right", "purity:A:right", "purity:B:left"})
  {
    SCOPED_TRACE(text);
    options.goal = *goalFromText(text);
    InclinationSearch search(options, 0.0);
    EXPECT_LT(seek(search, [&](double inclination) { return sieve.expected(inclination); }), 40);
    const double best = bestOf(options.goal, sieve, options);
    EXPECT_GT(std::abs(best - sieve.best()), 0.03);  // it is not that of Q
    EXPECT_NEAR(search.best(), best, options.resolution);
    EXPECT_NEAR(search.bestScore().goal.value, measured(options.goal, sieve.expected(best)).value,
                0.05 * search.bestScore().goal.value);
  }
}

/// Everything of A leaves on the left where the base is raised enough: further is no better.
TEST(InclinationSearch, endsWhereAGoalGrowsNoMore)
{
  const KnownSieve sieve;
  SearchOptions options;
  options.goal = *goalFromText("recovery:A:left");
  InclinationSearch search(options, 0.0);
  EXPECT_LT(seek(search, [&](double inclination) { return sieve.expected(inclination); }), 40);
  EXPECT_GT(search.best(), 0.3);
  EXPECT_EQ(search.bestScore().goal.value, 1.0);
}

/// A drop of a flow is relative to it.
TEST(InclinationSearch, seeksAgainWhereAFlowDrops)
{
  KnownSieve sieve;
  sieve.disks = 10000;
  SearchOptions options;
  options.goal = *goalFromText("throughput");
  InclinationSearch search(options, 0.0);
  seek(search, [&](double inclination) { return sieve.expected(inclination); });
  for (const double part : {0.9, 0.9, 0.9, 0.8, 0.8})
  {
    EXPECT_EQ(search.phase(), SearchPhase::HOLD);
    Outflow outflow = sieve.expected(search.next());
    outflow.duration /= part;
    search.take(outflow);
  }
  EXPECT_EQ(search.restarts(), 1u);
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
  const Outflow mixed = {{"A", "B"}, {{50, 50, 0}, {50, 50, 0}}, 10.0};
  for (int k = 0; k < 5; ++k)
  {
    search.take(mixed);
    EXPECT_EQ(search.phase(), SearchPhase::HOLD);
    search.take(sieve.expected(search.next()));
    EXPECT_EQ(search.phase(), SearchPhase::HOLD);
  }
  EXPECT_EQ(search.next(), held);
  EXPECT_NEAR(search.bestScore().quality.value, sieve.quality(held), 0.02);
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
  EXPECT_FALSE(search.bestScore().quality.defined);
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
                            return Outflow{{"A", "B"}, {{some(), some(), 0}, {some(), some(), 0}}, 10.0};
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
    Outflow outflow = sieve.expected(search.next());
    search.take(outflow);
    for (SpeciesBins& b : outflow.bins)
      std::swap(b.left, b.right);
    mirrored.take(outflow);
  }
}
}  // namespace
}  // namespace ratchet_sieve
