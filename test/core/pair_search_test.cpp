#include "search/pair_search.h"
#include "state/system_state.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "draws.h"
#include "reference_loop.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

TEST(TimeToTouch, KnownAnswers)
{
  EXPECT_DOUBLE_EQ(*timeToContact({3.0, 0.0}, {-1.0, 0.0}, 1.0), 2.0);
  EXPECT_FALSE(timeToContact({3.0, 0.0}, {1.0, 0.0}, 1.0));      // part
  EXPECT_FALSE(timeToContact({3.0, 1.1}, {-1.0, 0.0}, 1.0));     // pass
  EXPECT_EQ(*timeToContact({0.9, 0.0}, {-1.0, 0.0}, 1.0), 0.0);  // overlapping and approaching: now
  EXPECT_FALSE(timeToContact({0.9, 0.0}, {1.0, 0.0}, 1.0));      // overlapping and separating: ignored
}

double gapAt(const SystemState& system, int shift, double time)
{
  const double gravity = system.scene().gravity;
  const Eigen::Vector2d a = positionAt(system.disk(0), time, gravity);
  const Eigen::Vector2d b = positionAt(system.disk(1), time, gravity);
  const Image there = system.image(shift, time);
  return std::hypot(a.x() - b.x() - there.shift.x(), a.y() - b.y() - there.shift.y()) - system.radius(0) -
         system.radius(1);
}

/// Two disks at either end of a ring that turns fast, thrown at each other across the seam.
TEST(PairSearch, FindsTheFirstContactAcrossTheSeamOfATurningBase)
{
  EXPECT_TRUE(rc::check(
      []
      {
        SceneDefinition scene = test::mixture(0);
        scene.base.teeth = 4;
        SystemState system(scene);
        test::turnBase(system, {*rc::gen::element(0.1, 1.0, 5.0), *rc::gen::element(-1.0, 1.0)});
        const double until = *system.motion().nextChange();
        Disk left, right;
        left.position.x() = drawn(0.002, 0.006);
        right.position.x() = 0.08 - drawn(0.002, 0.006);
        left.position.y() = 0.02 + drawn(0.0, 0.005);
        right.position.y() = 0.02 + drawn(0.0, 0.005);
        left.velocity.x() = -drawn(0.0, 2.0);
        right.velocity.x() = drawn(0.0, 2.0);
        left.velocity.y() = drawn(-1.0, 1.0);
        right.velocity.y() = drawn(-1.0, 1.0);
        right.species = 1;
        test::addDisk(system, left);
        test::addDisk(system, right);
        const int shift = -1;  // the right disk's image one width to the left

        const auto found = ContactPrediction(system).pairsOf(0, 0.0).contactWith(1, shift);
        const double end = found.value_or(until);
        for (int i = 0; i < 2000; ++i)
          RC_ASSERT(gapAt(system, shift, end * i / 2000.0) > -1e-15);
        RC_CLASSIFY(!found.has_value(), "no contact");
        if (found)
          RC_ASSERT(std::abs(gapAt(system, shift, *found)) < 1e-14);
      }));
}

/// The base turns for years, until an image has sunk onto a disk: a step is then lost to the rounding of
/// time.
TEST(PairSearch, EndsOnABaseThatTurnsForYears)
{
  SceneDefinition scene = test::mixture(0);
  scene.base.teeth = 4;
  scene.base.inclination = -0.1;
  SystemState system(scene);
  test::turnBase(system, {1e-9, 1.0});
  Disk left, right;
  left.position = {0.0008, 0.021};
  right.position = {0.08, 0.02};
  test::addDisk(system, left);
  test::addDisk(system, right);
  const auto found = ContactPrediction(system).pairsOf(0, 1.0).contactWith(1, -1);
  ASSERT_TRUE(found);
  const double inclination = -0.1 + 1e-9 * *found;
  const Eigen::Vector2d way(0.0008 - 0.08 + 0.08 * std::cos(inclination),
                            0.001 + 0.08 * std::sin(inclination));
  EXPECT_NEAR(way.norm(), 0.002, 1e-15);
}

/// Many disks side by side give the same results as each alone, bit for bit.
TEST(PairSearch, LanesGiveTheEarliestOfAllContacts)
{
  EXPECT_TRUE(rc::check(
      []
      {
        SceneDefinition scene = test::mixture(0);
        scene.base.inclination = *rc::gen::element(0.0, 0.1);
        SystemState system(scene);
        const auto count = *rc::gen::inRange<std::uint32_t>(1, 40);
        for (std::uint32_t id = 0; id < count; ++id)
        {
          Disk disk;
          disk.position.x() = drawn(0.0, 0.05);
          disk.position.y() = drawn(0.01, 0.05);
          disk.velocity.x() = drawn(-0.5, 0.5);
          disk.velocity.y() = drawn(-0.5, 0.5);
          disk.species = *rc::gen::inRange(0U, 2U);
          test::addDisk(system, disk, drawn(0.0, 0.01));
        }
        std::vector<std::uint32_t> all(count);
        std::iota(all.begin(), all.end(), 0);
        const int shift = *rc::gen::inRange(-1, 2);
        const ContactPrediction prediction(system);
        const PairSearch search = prediction.pairsOf(0, 0.01);
        PairContact expected;
        for (std::uint32_t id = 1; id < count; ++id)
          if (const auto time = search.contactWith(id, shift))
            expected.keepEarlier({*time, id, shift});
        const PairContact found = search.firstAmong(all.data(), all.size(), shift);
        RC_CLASSIFY(found.time < 1.0, "contact");
        RC_ASSERT(found.time == expected.time);
        RC_ASSERT(found.partner == expected.partner);
      }));
}

/// A ring of disks that closes around one: they touch it at the same time.
TEST(PairSearch, TiesGoToTheSmallestId)
{
  constexpr std::uint32_t COUNT = 40;
  const SceneDefinition scene = test::mixture(0);
  SystemState system(scene);
  test::addDisk(system, Disk());
  std::vector<std::uint32_t> backwards;
  for (std::uint32_t id = COUNT; id >= 1; --id)
    backwards.push_back(id);
  for (std::uint32_t id = 1; id <= COUNT; ++id)
  {
    // On one of eight places that are mirror images of each other.
    const double x = id % 2 == 0 ? 0.005 : -0.005;
    const double y = id % 4 < 2 ? 0.012 : -0.012;
    Disk disk;
    disk.position = id % 8 < 4 ? Eigen::Vector2d(x, y) : Eigen::Vector2d(y, x);
    disk.velocity = -20.0 * disk.position;
    test::addDisk(system, disk);
  }
  const ContactPrediction prediction(system);
  const PairSearch search = prediction.pairsOf(0, 0.0);
  for (std::uint32_t id = 1; id <= COUNT; ++id)
    ASSERT_EQ(search.contactWith(id, 0), search.contactWith(1, 0));
  const PairContact found = search.firstAmong(backwards.data(), COUNT, 0);
  EXPECT_EQ(found.time, *search.contactWith(1, 0));
  EXPECT_EQ(found.partner, 1u);
}

}  // namespace
}  // namespace ratchet_sieve
