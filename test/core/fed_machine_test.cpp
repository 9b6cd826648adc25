#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "model/random.h"
#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double LONG = 25.0;  // s: long enough for two compactions

TEST(FedMachine, ForgetsTheDisksThatHaveLeft)
{
  for (const bool pairs : {true, false})
  {
    Simulation simulation(test::fedSieve(pairs));
    simulation.advanceTo(LONG);
    const std::size_t state = simulation.saveState().size();
    const std::size_t poured = 10 + static_cast<std::size_t>(400.0 * LONG);
    EXPECT_LT(state, poured * 100) << "all places are still there";
    std::uint64_t counted = 0;
    for (const SpeciesBins& bins : simulation.bins())
      counted += bins.left + bins.right + bins.on_base;
    EXPECT_EQ(counted, poured);
    test::expectNoOverlap(simulation);
  }
}

/// What left after `start`, counted from the exits that were told.
std::vector<SpeciesBins> exitsAfter(double start, const std::vector<ExitRecord>& exits, std::size_t species)
{
  std::vector<SpeciesBins> bins(species);
  for (const ExitRecord& exit : exits)
    if (exit.time > start)
      ++(exit.side == Exit::LEFT_BIN ? bins[exit.species].left : bins[exit.species].right);
  return bins;
}

void expectSameCounts(const std::vector<SpeciesBins>& some, const std::vector<SpeciesBins>& others)
{
  for (std::size_t s = 0; s < some.size(); ++s)
  {
    EXPECT_EQ(some[s].left, others[s].left);
    EXPECT_EQ(some[s].right, others[s].right);
    EXPECT_EQ(some[s].on_base, 0u);
  }
}

TEST(FedMachine, KeepsTheExitsOfAnIntervalHoweverOftenItIsAsked)
{
  constexpr double LENGTH = 0.5;  // s
  for (const bool pairs : {true, false})
  {
    Simulation seldom(test::fedSieve(pairs)), often(test::fedSieve(pairs));
    EXPECT_EQ(seldom.exitWindow().start, 0.0);
    std::vector<ExitRecord> exits;
    often.observeExits([&](const ExitRecord& exit) { exits.push_back(exit); });
    seldom.keepExits(LENGTH);
    often.keepExits(LENGTH);
    for (const double time : {0.1, 0.3, 0.7, 1.9, 2.0, 4.0})
    {
      often.advanceTo(time);
      const ExitWindow window = often.exitWindow();
      EXPECT_EQ(window.start, std::max(0.0, time - LENGTH));
      expectSameCounts(window.bins, exitsAfter(window.start, exits, window.bins.size()));
    }
    seldom.advanceTo(4.0);
    EXPECT_GT(seldom.exitWindow().bins[0].counted(), 0u);
    expectSameCounts(seldom.exitWindow().bins, often.exitWindow().bins);
    EXPECT_EQ(often.exitWindow(3.9).start, 3.9);
    expectSameCounts(often.exitWindow(3.9).bins, exitsAfter(3.9, exits, often.bins().size()));
  }
}

/// The disks that have entered by the ends of successive intervals of 10 ms, since the start.
std::vector<std::uint64_t> entered(const SceneDefinition& scene, std::size_t intervals)
{
  Simulation simulation(scene);
  std::vector<std::uint64_t> all;
  for (std::size_t k = 1; k <= intervals; ++k)
  {
    simulation.advanceTo(0.01 * static_cast<double>(k));
    all.push_back(0);
    for (const SpeciesBins& bins : simulation.bins())
      all.back() += bins.counted() + bins.on_base;
  }
  return all;
}

/// Intervals of a Poisson process have counts whose variance is their mean; those of an even feed of 4 disks
/// an interval have 0.
TEST(FedMachine, IsFedByAPoissonProcessOfTheSeedWhateverTheDrive)
{
  constexpr std::size_t INTERVALS = 2000;
  SceneDefinition scene = test::fedSieve(false);
  scene.feed.even = false;
  const std::vector<std::uint64_t> all = entered(scene, INTERVALS);
  double squares = 0.0;
  double correlated = 0.0;
  double last = 0.0;
  for (std::size_t k = 1; k < INTERVALS; ++k)
  {
    const double excess = static_cast<double>(all[k] - all[k - 1]) - 4.0;
    squares += excess * excess;
    correlated += excess * last;
    last = excess;
  }
  EXPECT_NEAR(static_cast<double>(all.back()), 4.0 * INTERVALS, 4.0 * std::sqrt(4.0 * INTERVALS));
  // The variance of the square of a Poisson deviation of mean 4 is 36.
  EXPECT_NEAR(squares / INTERVALS, 4.0, 4.0 * std::sqrt(36.0 / INTERVALS));
  EXPECT_NEAR(correlated / INTERVALS, 0.0, 4.0 * 4.0 / std::sqrt(INTERVALS));
  scene.base.frequency *= 1.7;
  scene.base.inclination = 0.1;
  EXPECT_EQ(entered(scene, INTERVALS), all);
  scene.seed += 1;
  EXPECT_NE(entered(scene, INTERVALS), all);
}

/// At the instant of each feed, the newest disk is above the feed's stretch; the disks of the start and those
/// poured on command are above the pour's.
TEST(FedMachine, PoursWhereItsStretchesAre)
{
  SceneDefinition scene = test::fedSieve(true);
  scene.base.teeth = 5;
  scene.pour.stretch = {0.06, 0.08};
  scene.feed.stretch = {0.02, 0.03};
  Simulation simulation(scene);
  const auto placeOf = [&](const DiskState& disk)
  {
    const DriveState base = simulation.base();
    const Eigen::Vector2d place(disk.x - base.horizontal_displacement, disk.y - base.displacement);
    return (Eigen::Rotation2Dd(-base.inclination) * place).x();
  };
  const auto expectWithin = [&](const DiskState& disk, const Stretch& stretch)
  {
    EXPECT_GE(placeOf(disk), stretch.from - 1e-12);
    EXPECT_LE(placeOf(disk), stretch.to + 1e-12);
  };
  for (const DiskState& disk : simulation.disks())
    expectWithin(disk, scene.pour.stretch);
  for (int fed = 1; fed <= 100; ++fed)
  {
    simulation.advanceTo(fed / scene.feed.rate);
    expectWithin(simulation.disks().back(), scene.feed.stretch);
  }
  simulation.pour(1, 3);
  const std::vector<DiskState> disks = simulation.disks();
  for (std::size_t i = disks.size() - 3; i < disks.size(); ++i)
    expectWithin(disks[i], scene.pour.stretch);
}

/// A disk keeps its number and its radius through compactions.
TEST(FedMachine, NumbersEveryDiskThatEntersOnce)
{
  Simulation simulation(test::withSizes(test::fedSieve(true)));
  std::map<std::uint32_t, DiskState> before;
  std::uint32_t newest = 0;
  for (double time = 0.0; time < LONG; time += 0.01)
  {
    simulation.advanceTo(time);
    std::map<std::uint32_t, DiskState> now;
    const std::vector<DiskState> disks = simulation.disks();
    for (std::size_t k = 0; k < disks.size(); ++k)
    {
      const DiskState& disk = disks[k];
      ASSERT_TRUE(k == 0 || disks[k - 1].id < disk.id);
      const auto known = before.find(disk.id);
      if (known == before.end())
      {
        ASSERT_TRUE(before.empty() || disk.id > newest) << "a number came back";
      }
      else
      {
        ASSERT_EQ(known->second.species, disk.species);
        ASSERT_EQ(known->second.radius, disk.radius);
        ASSERT_NEAR(disk.displacement - known->second.displacement, disk.x - known->second.x, 1e-9);
        ASSERT_LT(std::abs(disk.x - known->second.x), 0.05);
      }
      now[disk.id] = disk;
    }
    if (!now.empty())
      newest = std::max(newest, now.rbegin()->first);
    before = std::move(now);
  }
  EXPECT_GT(newest, 5000u);
}

TEST(FedMachine, SumsUpWhatItForgets)
{
  // The means, computed from the observed states of every disk.
  Simulation simulation(test::fedSieve(true));
  simulation.advanceTo(1.0);
  double displacement = 0.0;
  double time_sum = 0.0;
  std::map<std::uint32_t, DiskState> before;
  const auto look = [&]
  {
    std::map<std::uint32_t, DiskState> now;
    for (const DiskState& disk : simulation.disks())
      if (disk.species == 0)
        now[disk.id] = disk;
    return now;
  };
  before = look();
  constexpr double STEP = 1.0 / 1024.0;
  for (double time = 1.0 + STEP; time <= LONG; time += STEP)
  {
    simulation.advanceTo(time);
    const auto now = look();
    for (const auto& [id, disk] : now)
      if (const auto known = before.find(id); known != before.end())
      {
        displacement += disk.displacement - known->second.displacement;
        time_sum += STEP;
      }
    before = now;
  }
  const double mean = simulation.means().at(0).mean_vx.value();
  // The last part of each disk's path, and a part of the first step, are not observed.
  EXPECT_NEAR(mean, displacement / time_sum, 0.02 * std::abs(mean));
}

std::vector<ExitRecord> exitsOf(Simulation& simulation, double end)
{
  std::vector<ExitRecord> exits;
  simulation.observeExits([&exits](const ExitRecord& record) { exits.push_back(record); });
  simulation.advanceTo(end);
  simulation.observeExits({});
  return exits;
}

TEST(FedMachine, TellsOfEachDiskThatLeaves)
{
  for (const bool pairs : {true, false})
  {
    Simulation simulation(test::withSizes(test::fedSieve(pairs)));
    const double width = simulation.scene().base.width();
    double last = 0.0;
    std::vector<SpeciesBins> bins(simulation.scene().species.size());
    for (const ExitRecord& exit : exitsOf(simulation, 10.0))
    {
      EXPECT_GE(exit.time, last) << "in the order of time";
      last = exit.time;
      SpeciesBins& of = bins[exit.species];
      ++(exit.side == Exit::LEFT_BIN ? of.left : of.right);
      (exit.side == Exit::LEFT_BIN ? of.left_mass : of.right_mass) += exit.mass;
      EXPECT_EQ(exit.mass, simulation.scene().species[exit.species].massOf(exit.radius));
      EXPECT_EQ(exit.place > 0.5 * width, exit.side == Exit::RIGHT_BIN) << exit.place;
    }
    const std::vector<SpeciesBins> counted = simulation.bins();
    for (std::size_t s = 0; s < bins.size(); ++s)
    {
      EXPECT_GT(bins[s].left + bins[s].right, 100u);
      EXPECT_EQ(bins[s].left, counted[s].left);
      EXPECT_EQ(bins[s].right, counted[s].right);
      EXPECT_EQ(bins[s].left_mass, counted[s].left_mass);
      EXPECT_EQ(bins[s].right_mass, counted[s].right_mass);
    }
  }
}

TEST(FedMachine, PoursEachDiskOfItsListAtItsTime)
{
  SceneDefinition scene = test::fedSieve(true);
  scene.feed = {};
  scene.base.teeth = 20;
  // Smaller, larger and heavier than its species.
  const SpeciesDefinition species = scene.species[1];
  scene.feed.disks = {{0.0, 0, 0.5 * species.radius, species.mass},
                      {0.25, 1, 1.5 * species.radius, 3.0 * species.mass},
                      {0.25, 1, species.radius, species.mass}};
  for (SpeciesDefinition& one : scene.species)
    one.count = 0;
  Simulation simulation(scene);
  simulation.advanceTo(0.0);
  ASSERT_EQ(simulation.disks().size(), 1u);
  EXPECT_EQ(simulation.disks()[0].radius, scene.feed.disks[0].radius);
  simulation.advanceTo(0.2499);
  EXPECT_EQ(simulation.disks().size(), 1u);
  simulation.advanceTo(0.25);
  ASSERT_EQ(simulation.disks().size(), 3u);
  EXPECT_EQ(simulation.disks()[1].radius, scene.feed.disks[1].radius);
  EXPECT_EQ(exitsOf(simulation, 1e3).size(), 3u);
}

}  // namespace
}  // namespace ratchet_sieve
