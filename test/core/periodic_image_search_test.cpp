#include "search/pair_search.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <Eigen/Geometry>

#include "draws.h"

namespace ratchet_sieve
{
namespace
{
constexpr double FOR_EVER = std::numeric_limits<double>::infinity();

/// Every image, one by one.
std::optional<PeriodicImageSearch::Touch> slowly(const PeriodicImageSearch& ring,
                                                 const Eigen::Vector2d& place,
                                                 const Eigen::Vector2d& velocity, double distance)
{
  std::optional<PeriodicImageSearch::Touch> first;
  for (int shift = -ring.most_laps; shift <= ring.most_laps; ++shift)
  {
    const double length = shift * ring.width;
    const Eigen::Vector2d image(length * ring.rotation.cosine, length * ring.rotation.sine);
    const auto time_to_contact = timeToContact(place - image, velocity, distance);
    if (time_to_contact && (!first || *time_to_contact < first->time_to_contact))
      first = PeriodicImageSearch::Touch{*time_to_contact, shift};
  }
  return first;
}

TEST(PeriodicImageSearch, FindsWhatLookingAtEveryImageFinds)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const double angle = drawn(-1.5, 1.5);
        const double width = drawn(0.01, 0.3);
        const PeriodicImageSearch ring{
            {std::cos(angle), std::sin(angle)}, width, 1.0 / width, *rc::gen::inRange(1, 40)};
        const double distance = drawn(0.0001, 1.0) * width;
        // Also slow across the row, so that several images are passed while it is within reach.
        const double across_rate = drawn(-1.0, 1.0) * std::pow(10.0, drawn(-6.0, 1.0));
        const double along_rate = drawn(-1.0, 1.0) * std::pow(10.0, drawn(-2.0, 1.0));
        const double across = drawn(-3.0, 3.0) * (*rc::gen::arbitrary<bool>() ? distance : width);
        const double along = drawn(-0.5, 0.5) * ring.most_laps * width;
        const Eigen::Rotation2Dd rotation(angle);
        const Eigen::Vector2d place = rotation * Eigen::Vector2d(along, across);
        const Eigen::Vector2d velocity = rotation * Eigen::Vector2d(along_rate, across_rate);

        const auto expected = slowly(ring, place, velocity, distance);
        const auto touch = ring.firstTouch(place, velocity, distance, FOR_EVER);
        RC_ASSERT(touch.has_value() == expected.has_value());
        if (!touch)
          return;
        RC_ASSERT(touch->time_to_contact == expected->time_to_contact);
        // With a time limit: only contacts up to it are found.
        RC_ASSERT(ring.firstTouch(place, velocity, distance, expected->time_to_contact).has_value());
        if (expected->time_to_contact > 0.0)
          RC_ASSERT(
              !ring.firstTouch(place, velocity, distance, 0.999 * expected->time_to_contact).has_value());
      }));
}

TEST(PeriodicImageSearch, MeetsAnImageManyLapsAway)
{
  const PeriodicImageSearch ring{{1.0, 0.0}, 0.2, 5.0, 100};
  // One metre above the row, at 10 m/s along it and 1 m/s towards it: 10 m, 50 widths away.
  const auto touch = ring.firstTouch({0.0, 1.0}, {10.0, -1.0}, 0.002, FOR_EVER);
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->shift, 50);
  EXPECT_NEAR(touch->time_to_contact, 1.0, 0.001);
  EXPECT_FALSE(
      (PeriodicImageSearch{{1.0, 0.0}, 0.2, 5.0, 49}.firstTouch({0.0, 1.0}, {10.0, -1.0}, 0.002, FOR_EVER)));
}

TEST(PeriodicImageSearch, AtRestBesideAnImageMeetsNothing)
{
  const PeriodicImageSearch ring{{1.0, 0.0}, 0.2, 5.0, 10};
  EXPECT_FALSE(ring.firstTouch({0.0, 0.0}, {0.0, 0.0}, 0.002, FOR_EVER));
  EXPECT_FALSE(ring.firstTouch({0.1, 0.0}, {0.0, 0.0}, 0.002, FOR_EVER));
  // Along the row, however slowly the height changes.
  EXPECT_EQ(ring.firstTouch({0.1, 0.0}, {1.0, 1e-308}, 0.002, FOR_EVER)->shift, 1);
}

}  // namespace
}  // namespace ratchet_sieve
