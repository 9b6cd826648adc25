// What a scene asks to be observed, against a slow reader of its disks.
#include "ratchet_sieve/core/results.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "observed_rows.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/statistics/time_histogram.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition observedScene(bool pairs)
{
  SceneDefinition scene = test::openMixture(20);
  scene.base.teeth = 3;
  scene.base.inclination = 0.02;
  scene.feed.rate = 60.0;
  scene.settle = 0.7;
  scene.contact.pair_collisions = pairs;
  scene.observe = observableNames();
  return scene;
}

double total(const std::vector<std::optional<double>>& values)
{
  double sum = 0.0;
  for (const std::optional<double>& value : values)
    sum += value.value();
  return sum;
}

struct Bin
{
  double from, to, count;
};

std::vector<Bin> binsOf(const TimeHistogram& histogram)
{
  std::vector<Bin> bins;
  histogram.forEachBin([&](double from, double to, double count) { bins.push_back({from, to, count}); });
  return bins;
}

double total(const std::vector<Bin>& bins)
{
  double sum = 0.0;
  for (const Bin& bin : bins)
    sum += bin.count;
  return sum;
}

TEST(TimeHistogram, HasTheMeanAndNearlyTheQuantilesOfItsTimes)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const auto parts =
            *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 1'000'000)));
        TimeHistogram histogram;
        std::vector<double> times;
        for (const int part : parts)
          times.push_back(1e-4 * part);
        double sum = 0.0;
        for (const double time : times)
        {
          histogram.add(time);
          sum += time;
        }
        std::sort(times.begin(), times.end());
        const auto n = static_cast<double>(times.size());
        RC_ASSERT(histogram.count() == n);
        RC_ASSERT(std::abs(*histogram.mean() - sum / n) < 1e-12 * sum);
        for (const double share : {0.1, 0.5, 0.9, 1.0})
        {
          const double exact = times[static_cast<std::size_t>(std::ceil(share * n)) - 1];
          RC_ASSERT(std::abs(*histogram.quantile(share) / exact - 1.0) < 1.0 / 30.0);
        }
        const std::vector<Bin> bins = binsOf(histogram);
        RC_ASSERT(total(bins) == n);
        RC_ASSERT(bins.front().from <= times.front());
        RC_ASSERT(bins.back().to > times.back());
      }));
}

TEST(TimeHistogram, TellsNothingOfNoTimeAndClampsExtremes)
{
  TimeHistogram histogram;
  EXPECT_FALSE(histogram.mean());
  EXPECT_FALSE(histogram.quantile(0.5));
  EXPECT_TRUE(binsOf(histogram).empty());
  for (const double time : {0.0, 1e-300, 1e300})
    histogram.add(time);
  EXPECT_EQ(histogram.count(), 3.0);
  EXPECT_EQ(total(binsOf(histogram)), 3.0);
}

/// The reader looks at the disks a thousand times a second: a disk that is there no more has left.
TEST(ResidenceTimes, AreThoseOfDisksThatComeAndLeave)
{
  for (const bool pairs : {true, false})
  {
    const SceneDefinition scene = observedScene(pairs);
    Simulation simulation(scene);
    constexpr double STRIDE = 1e-3;
    struct Stay
    {
      double from;
      std::uint32_t species;
    };
    std::map<std::uint32_t, Stay> stays;
    std::vector<double> sums(2), counts(2);
    for (int k = 0; k <= 6000; ++k)
    {
      simulation.advanceTo(k * STRIDE);
      std::map<std::uint32_t, Stay> still;
      for (const DiskState& disk : simulation.disks())
        still[disk.id] = stays.count(disk.id) > 0 ? stays[disk.id] : Stay{k * STRIDE, disk.species};
      for (const auto& [id, stay] : stays)
        if (still.count(id) == 0 && k * STRIDE > scene.settle)
        {
          sums[stay.species] += k * STRIDE - stay.from;
          counts[stay.species] += 1.0;
        }
      stays = still;
    }
    const Observed observed = test::named(simulation.observed(), "residence_times");
    ASSERT_EQ(observed.rows.size(), 4u);
    for (std::size_t s = 0; s < 2; ++s)
    {
      double sum = 0.0, count = 0.0;
      for (const ObservedRow& row : observed.rows)
        if (row.species == scene.species[s].name)
        {
          count += *test::numberOf(row, "count");
          sum += *test::numberOf(row, "count") * test::numberOf(row, "mean").value_or(0.0);
          EXPECT_EQ(total(test::columnOf(row, "count")), *test::numberOf(row, "count"));
        }
      EXPECT_GT(count, 30.0);
      EXPECT_EQ(count, counts[s]);
      EXPECT_NEAR(sum / count, sums[s] / counts[s], 2.0 * STRIDE);
    }
  }
}

TEST(MassFlow, IsTheMassInTheBinsSinceSettleOverTime)
{
  for (const bool pairs : {true, false})
  {
    const SceneDefinition scene = observedScene(pairs);
    Simulation simulation(scene);
    simulation.advanceTo(scene.settle);
    const std::vector<SpeciesBins> before = simulation.bins();
    const double end = simulation.blockEnd(60);
    simulation.advanceTo(end);
    const std::vector<SpeciesBins> after = simulation.bins();
    const Observed observed = test::named(simulation.observed(), "mass_flow");
    for (std::size_t k = 0; k < observed.rows.size(); ++k)
    {
      const ObservedRow& row = observed.rows[k];
      const std::size_t s = k % 2;
      EXPECT_EQ(row.place, k < 2 ? "left" : "right");
      EXPECT_EQ(row.species, scene.species[s].name);
      const auto mass = k < 2 ? &SpeciesBins::left_mass : &SpeciesBins::right_mass;
      const double fallen = after[s].*mass - before[s].*mass;
      EXPECT_NEAR(*test::numberOf(row, "mass"), fallen, 1e-12);
      EXPECT_NEAR(*test::numberOf(row, "mean"), fallen / (end - scene.settle), 1e-12);
      EXPECT_TRUE(test::numberOf(row, "stderr"));
      // The blocks cover all of the time.
      const auto& flow = test::columnOf(row, "flow");
      ASSERT_EQ(flow.size(), 60u);
      EXPECT_NEAR(test::columnOf(row, "time").back().value(), end, 1e-9);
      EXPECT_NEAR(total(flow) / 60.0, fallen / (end - scene.settle), 1e-12);
    }
  }
}

/// A run that begins at another time than 0, as that of a machine that is reset: nothing was seen until the
/// end of `settle`, and nothing at that instant.
TEST(Observables, HaveSeenNothingWhereTheirTimeHasNotBegun)
{
  for (const double settle : {0.0, 0.7})
  {
    SceneDefinition scene = observedScene(true);
    scene.settle = settle;
    Simulation simulation(scene, 100.0);
    for (const double begun : {0.0, 0.9})
    {
      if (begun > 0.0)
        simulation.advanceTo(100.0 + begun * settle);
      const std::vector<Observed> all = simulation.observed();
      for (const Observed& observed : all)
        for (const ObservedRow& row : observed.rows)
          for (const auto& number : row.numbers)
            EXPECT_EQ(number.value.value_or(0.0), 0.0) << observed.name << " " << number.name;
      for (const ObservedRow& row : test::named(all, "mass_flow").rows)
        EXPECT_FALSE(test::numberOf(row, "mean")) << simulation.time();
    }
    simulation.advanceTo(103.0);
    EXPECT_TRUE(test::numberOf(test::named(simulation.observed(), "mass_flow").rows[0], "mean"));
  }
}

TEST(Observables, RefuseAnUnknownName)
{
  SceneDefinition scene = test::mixture(1);
  scene.observe = {"colour"};
  EXPECT_THROW(Simulation{scene}, std::invalid_argument);
}

}  // namespace
}  // namespace ratchet_sieve
