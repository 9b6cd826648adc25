#include "state/placement.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "ratchet_sieve/geometry/pour.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// The lowest height at which a disk touches none of the others, found by testing all of them.
double lowestByClimbing(const PlacedDisk& disk, double lowest, const std::vector<PlacedDisk>& others,
                        double width, bool periodic)
{
  std::vector<std::pair<double, double>> forbidden;
  for (const PlacedDisk& other : others)
    for (const double image : {-width, 0.0, width})
    {
      const double ds = disk.s - other.s - image;
      const double distance = (disk.radius + other.radius) * (1.0 + 1e-6);
      if (std::abs(ds) >= distance || (!periodic && image != 0.0))
        continue;
      const double half = std::sqrt(distance * distance - ds * ds);
      forbidden.emplace_back(other.n - half, other.n + half);
    }
  std::sort(forbidden.begin(), forbidden.end());
  double height = lowest;
  for (const auto& [from, to] : forbidden)
    if (from < height)
      height = std::max(height, to);
  return height;
}

/// Lowest undersides of poured disks [m].
constexpr double LOWEST = 0.028;

PourBed bedOf(const BaseDefinition& base, Boundary boundary, const Stretch& stretch)
{
  return {base.width(), boundary == Boundary::PERIODIC, stretch.from, stretch.to, LOWEST};
}

/// Heaps of some tens of disks, in which the free positions are deep below the surface.
TEST(Pour, PlacesEachDiskAsLowAsThereIsRoomToTheBit)
{
  EXPECT_TRUE(rc::check(
      []
      {
        BaseDefinition base;
        base.teeth = *rc::gen::element(1, 2, 5);
        const Boundary boundary = *rc::gen::element(Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED);
        // Those that differ little share a search.
        const std::vector<double> radii = {*rc::gen::element(0.001, 0.004, 0.0042, 0.0043), 0.004,
                                           *rc::gen::element(0.0005, 0.002, 0.00419, 0.0095)};
        const double largest = *std::max_element(radii.begin(), radii.end());
        Pour pour(bedOf(base, boundary, Stretch()), 2.0 * largest, true);
        Random random(*rc::gen::arbitrary<std::uint64_t>());
        std::vector<PlacedDisk> disks;
        const auto there = *rc::gen::inRange(0, 100);
        for (int i = 0; i < there; ++i)
        {
          disks.push_back({base.width() * random.uniform(), 0.2 * random.uniform(), radii[random.below(3)]});
          pour.occupy(disks.back());
        }
        for (int i = 0; i < 500; ++i)
        {
          const double radius = radii[random.below(3)];
          const PlacedDisk disk = pour.place(radius, random.uniform());
          const double lowest = LOWEST + radius;
          RC_ASSERT(disk.s >= 0.0 && disk.s <= base.width());
          RC_ASSERT(disk.n ==
                    lowestByClimbing(disk, lowest, disks, base.width(), boundary == Boundary::PERIODIC));
          disks.push_back(disk);
        }
      }));
}

/// Uniform on its stretch, as far as the ends leave room.
TEST(Pour, StaysOnItsStretch)
{
  BaseDefinition base;
  const double radius = 0.004;
  struct Given
  {
    Boundary boundary;
    Stretch stretch;
    double from, to;
  };
  for (const Given& given :
       {Given{Boundary::PERIODIC, {}, 0.0, 0.4}, Given{Boundary::PERIODIC, {0.1, 0.15}, 0.1, 0.15},
        Given{Boundary::PERIODIC, {0.3, 0.4}, 0.3, 0.4}, Given{Boundary::OPEN, {0.0, 0.1}, radius, 0.1},
        Given{Boundary::WALLED, {0.39, 0.4}, 0.39, 0.4 - radius},
        Given{Boundary::WALLED, {0.4, 0.4}, 0.4 - radius, 0.4 - radius},
        Given{Boundary::OPEN, {0.0, 0.0}, radius, radius}, Given{Boundary::OPEN, {0.2, 0.2}, 0.2, 0.2}})
  {
    Pour pour(bedOf(base, given.boundary, given.stretch), 2.0 * radius, true);
    Random random(3);
    const int count = 400;
    std::vector<double> places;
    for (int i = 0; i < count; ++i)
      places.push_back(pour.place(radius, random.uniform()).s);
    std::sort(places.begin(), places.end());
    EXPECT_GE(places.front(), given.from - 1e-15);
    EXPECT_LE(places.back(), given.to + 1e-15);
    for (int i = 0; i < count; ++i)
      EXPECT_NEAR(places[i], given.from + (given.to - given.from) * (i + 0.5) / count,
                  (given.to - given.from) * 1.63 / std::sqrt(count) + 1e-15);
  }
}

TEST(DrawSpecies, FollowsTheShares)
{
  auto species = test::mixture(0).species;
  species[0].share = 3.0;
  species[1].share = 1.0;
  Random random(1);
  int first = 0;
  for (int i = 0; i < 4000; ++i)
    first += drawSpecies(species, random) == 0;
  EXPECT_NEAR(first, 3000, 82);  // 3 sigma of the binomial
}

}  // namespace
}  // namespace ratchet_sieve
