// Profiles over the height above the base: against a bouncing ball, and against a slow reader of the disks.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "constants.h"
#include "observed_rows.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/statistics/height_slices.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
std::vector<double> column(const ObservedRow& row, const std::string& name)
{
  std::vector<double> values;
  for (const std::optional<double>& value : test::columnOf(row, name))
    values.push_back(value.value_or(std::nan("")));
  return values;
}

/// The sum of a slice's times is that of the flights, and so are the moments of the velocity; each slice's
/// time is that of a reader of 20,000 instants.
TEST(HeightSlices, AreThoseOfManyInstants)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const auto drawn = [](int low, int high) { return 1e-3 * *rc::gen::inRange(low, high); };
        const double duration = drawn(1, 1000);
        const double up = drawn(-3000, 3000), acceleration = drawn(-9810, 9810);
        const double start = drawn(0, 500);
        const double end = start + (up + 0.5 * acceleration * duration) * duration;
        const double along = drawn(-1000, 1000), later = drawn(-1000, 1000);
        HeightSlices slices(0.05, 2);
        slices.add({duration, {start, end}, {along, later}, {up, up + acceleration * duration}, 2.0}, 1);
        constexpr int INSTANTS = 20'000;
        std::map<std::size_t, double> expected;
        for (int k = 0; k < INSTANTS; ++k)
        {
          const double t = duration * (k + 0.5) / INSTANTS;
          const double height = start + (up + 0.5 * acceleration * t) * t;
          expected[static_cast<std::size_t>(std::max(0.0, std::floor(height / 0.05)))] += duration / INSTANTS;
        }
        HeightSlices::Sums all;
        for (std::size_t slice = 0; slice < slices.count(); ++slice)
        {
          RC_ASSERT(slices.at(slice, 0).time == 0.0);
          const HeightSlices::Sums& sums = slices.at(slice, 1);
          // At each end of each stay, of which there are two at most, half an instant.
          RC_ASSERT(std::abs(sums.time - expected[slice]) < 2.01 * duration / INSTANTS);
          RC_ASSERT(sums.weight == 2.0 * sums.time);
          all += sums;
        }
        RC_ASSERT(std::abs(all.time - duration) < 1e-12);
        RC_ASSERT(std::abs(all.upwards - 2.0 * (end - start)) < 1e-9);
        RC_ASSERT(std::abs(all.along - duration * (along + later)) < 1e-9);
        const double last = up + acceleration * duration;
        const double squared =
            duration / 3.0 *
            (along * along + along * later + later * later + up * up + up * last + last * last);
        RC_ASSERT(std::abs(all.squared - 2.0 * squared) < 1e-9 * (1.0 + squared));
      }));
}

TEST(HeightSlices, EndAtTheLast)
{
  HeightSlices slices(0.01, 1);
  slices.add({1.0, {9.0, 11.0}, {0.0, 0.0}, {2.0, 2.0}, 1.0}, 0);
  EXPECT_EQ(slices.count(), HeightSlices::MOST);
  EXPECT_NEAR(slices.timeAbove(), 0.5, 1e-12);
  EXPECT_NEAR(slices.heightIntegral(), 10.0, 1e-12);
}

/// A ball that bounces for ever, of height H over its lowest place: of its time, the share 1 - sqrt(1 - h/H)
/// is spent below h, and its velocity there is that of the fall.
TEST(HeightProfile, OfABouncingBallIsThatOfItsParabola)
{
  constexpr double HEIGHT = 0.1, GRAVITY = 9.81, RADIUS = 0.001, SLICE = 0.01;
  SceneDefinition scene = test::singleParticles(0);
  scene.base.tooth_height = 0.0;
  scene.base.amplitude = scene.base.frequency = 0.0;
  scene.species[0].contact = {1.0, 0.0, -1.0};
  scene.contact.min_rebound_speed = 0.0;
  scene.initial = {{0, 0.1, RADIUS + HEIGHT, 0.3, 0.0, 0.0}};
  scene.observe = {"height_profile"};
  scene.height_profile.slice = SLICE;
  const double period = 2.0 * std::sqrt(2.0 * HEIGHT / GRAVITY);
  Simulation simulation(scene);
  simulation.advanceTo(20.0 * period);
  const ObservedRow row = simulation.observed()[0].rows[0];
  const auto share = [=](double h) { return 1.0 - std::sqrt(1.0 - std::clamp(h / HEIGHT, 0.0, 1.0)); };
  const auto cube = [=](double h) { return std::pow(std::clamp(HEIGHT - h, 0.0, HEIGHT), 1.5); };
  const std::vector<double> from = column(row, "from"), density = column(row, "number_density");
  ASSERT_EQ(from.size(), 11u);
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    const double low = from[k] - RADIUS, high = low + SLICE;
    const double time = share(high) - share(low);
    EXPECT_NEAR(density[k] * SLICE * scene.base.width(), time, 1e-9);
    // The integral of v dh over that of dh / v.
    const double squared = (2.0 * GRAVITY / 3.0) * (cube(low) - cube(high)) / (time * std::sqrt(HEIGHT));
    EXPECT_NEAR(column(row, "temperature")[k], 0.5 * scene.species[0].mass * squared, 1e-10);
    EXPECT_NEAR(column(row, "velocity_along")[k], 0.3, 1e-9);
    EXPECT_NEAR(column(row, "velocity_up")[k], 0.0, 1e-7);
  }
  EXPECT_NEAR(*test::numberOf(row, "disks"), 1.0, 1e-12);
  EXPECT_NEAR(*test::numberOf(row, "mean_height"), RADIUS + 2.0 / 3.0 * HEIGHT, 1e-9);
  EXPECT_NEAR(*test::numberOf(row, "median_height"), RADIUS + 0.75 * HEIGHT, 0.1 * SLICE);
  EXPECT_EQ(*test::numberOf(row, "share_above"), 0.0);
}

TEST(HeightProfile, CountsFromTheLowestCorners)
{
  SceneDefinition scene = test::singleParticles(0);
  scene.gravity = 0.0;
  scene.base.profile = {{0.0, 0.0}, {0.01, -0.005}, {0.02, 0.0}};
  scene.base.amplitude = 0.0;
  scene.initial = {{0, 0.1, 0.0205, 0.0, 0.0, 0.0}};
  scene.observe = {"height_profile"};
  Simulation simulation(scene);
  simulation.advanceTo(1.0);
  const ObservedRow row = simulation.observed()[0].rows[0];
  EXPECT_NEAR(*test::numberOf(row, "mean_height"), 0.0255, 1e-12);
  // Slices as high as the smallest radius, up to that of the disk.
  EXPECT_EQ(column(row, "from").size(), 26u);
  EXPECT_NEAR(column(row, "number_density").back() * 0.001 * scene.base.width(), 1.0, 1e-12);
}

/// Sums of a reader that looks at all disks at many instants.
struct SlowProfile
{
  struct Slice
  {
    double count = 0.0, along = 0.0, up = 0.0;
  };
  double instants = 0.0;
  double height = 0.0, count = 0.0;
  std::map<std::pair<int, int>, Slice> slices;  ///< by phase and slice

  void look(const Simulation& simulation, double slice, int phases, double inclination_rate)
  {
    instants += 1.0;
    const DriveState base = simulation.base();
    const double c = std::cos(base.inclination), s = std::sin(base.inclination);
    for (const DiskState& disk : simulation.disks())
    {
      const double dx = disk.x - base.horizontal_displacement, dy = disk.y - base.displacement;
      const double vx = disk.vx - base.horizontal_velocity, vy = disk.vy - base.velocity;
      const double along = c * dx + s * dy, n = -s * dx + c * dy;
      Slice& at = slices[{static_cast<int>(base.phase / (2.0 * PI) * phases), static_cast<int>(n / slice)}];
      at.count += 1.0;
      at.along += c * vx + s * vy + inclination_rate * n;
      at.up += -s * vx + c * vy - inclination_rate * along;
      height += n;
      count += 1.0;
    }
  }
};

struct Case
{
  const char* name;
  SceneDefinition scene;
  double turn;  ///< to this inclination, from 0.3 s on [rad]
};

std::vector<Case> cases()
{
  SceneDefinition open = test::openMixture(15);
  open.base.teeth = 4;
  open.feed.rate = 40.0;
  SceneDefinition single = open;
  single.contact.pair_collisions = false;
  SceneDefinition walled = test::onAnOrbit(test::mixture(12));
  walled.base.teeth = 4;
  walled.boundary = Boundary::WALLED;
  walled.base.inclination = 0.2;
  walled.base.drive_frame = DriveFrame::BASE;
  SceneDefinition ring = test::mixture(12);
  ring.base.teeth = 4;
  ring.base.inclination = -0.1;
  SceneDefinition steps = ring;
  steps.accuracy.method = Method::STEPS;
  steps.accuracy.step = 2e-5;  // within a step a reader does not see its contacts yet
  SceneDefinition single_ring = test::singleParticles(30);
  return {{"open", open, 0.0}, {"single", single, 0.0}, {"walled", walled, 0.2},
          {"ring", ring, 0.1}, {"steps", steps, 0.1},   {"single ring", single_ring, 0.1}};
}

TEST(HeightProfile, IsThatOfASlowReader)
{
  constexpr double STRIDE = 1.0 / 4099.0, START = 0.3, END = 3.3, RATE = 0.05;
  for (Case& each : cases())
  {
    SCOPED_TRACE(each.name);
    each.scene.settle = START;
    each.scene.observe = {"height_profile"};
    each.scene.height_profile = {0.004, 2};
    Simulation simulation(each.scene);
    const bool turns = each.turn != each.scene.base.inclination;
    SlowProfile slow;
    simulation.advanceTo(START);
    if (turns)
    {
      simulation.setSlewRates({RATE, 1.0, 1.0});
      simulation.command(Quantity::INCLINATION, each.turn);
    }
    double before = simulation.base().inclination;
    for (int k = 0; START + (k + 0.5) * STRIDE < END; ++k)
    {
      simulation.advanceTo(START + (k + 0.5) * STRIDE);
      const double now = simulation.base().inclination;
      slow.look(simulation, 0.004, 2, now == before ? 0.0 : std::copysign(RATE, now - before));
      before = now;
    }
    simulation.advanceTo(END);
    double disks = 0.0, height = 0.0;
    std::map<std::pair<int, int>, SlowProfile::Slice> seen;
    const Observed observed = simulation.observed()[0];
    for (const ObservedRow& row : observed.rows)
    {
      disks += *test::numberOf(row, "disks");
      height += *test::numberOf(row, "disks") * *test::numberOf(row, "mean_height");
      const auto phase = column(row, "phase_from"), from = column(row, "from");
      const auto density = column(row, "number_density");
      const auto along = column(row, "velocity_along"), up = column(row, "velocity_up");
      for (std::size_t k = 0; k < from.size(); ++k)
        if (density[k] > 0.0)
        {
          SlowProfile::Slice& slice = seen[{static_cast<int>(std::lround(phase[k] / PI)),
                                            static_cast<int>(std::lround(250.0 * from[k]))}];
          const double count = density[k] * 0.004 * each.scene.base.width();
          slice.count += count;
          slice.along += count * along[k];
          slice.up += count * up[k];
        }
    }
    EXPECT_NEAR(disks, slow.count / slow.instants, 1e-3 * disks);
    EXPECT_NEAR(height, slow.height / slow.instants, 1e-3 * height);
    // Half of the instants are in each phase.
    for (const auto& [place, slice] : seen)
    {
      const double instants = 0.5 * slow.instants;
      const SlowProfile::Slice& expected = slow.slices[place];
      EXPECT_NEAR(slice.count, expected.count / instants, 0.01 * slice.count + 3e-3)
          << place.first << " " << place.second;
      EXPECT_NEAR(slice.along, expected.along / instants, 0.01 * slice.count + 3e-3)
          << place.first << " " << place.second;
      EXPECT_NEAR(slice.up, expected.up / instants, 0.01 * slice.count + 3e-3)
          << place.first << " " << place.second;
    }
  }
}

}  // namespace
}  // namespace ratchet_sieve
