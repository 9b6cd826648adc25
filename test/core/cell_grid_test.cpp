#include "search/cell_grid.h"

#include <map>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "search/cell_layout.h"

namespace ratchet_sieve
{
namespace
{

struct Point
{
  double s, n;
};

using Sighting = std::tuple<std::uint32_t, int>;

/// Every disk around a cell with its shift; each is seen once.
std::set<Sighting> sightings(const CellGrid& grid, CellGrid::Cell cell, const CellGrid::Surroundings& around)
{
  std::set<Sighting> seen;
  std::vector<std::uint32_t> list;
  grid.visit(cell, around, list,
             [&](const std::uint32_t* ids, std::size_t count, int shift)
             {
               for (std::size_t i = 0; i < count; ++i)
                 EXPECT_TRUE(seen.emplace(ids[i], shift).second);
             });
  return seen;
}

TEST(CellGrid, SeesEveryDiskWithinReachAsAllPairsDo)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const double width = *rc::gen::element(0.05, 0.1, 1.0);
        const double reach = 0.04;
        const bool periodic = *rc::gen::arbitrary<bool>();
        const auto cells = *rc::gen::container<std::vector<std::pair<int, int>>>(
            rc::gen::pair(rc::gen::inRange(0, 1000), rc::gen::inRange(-100, 1500)));
        std::vector<Point> points;
        for (const auto& [s, n] : cells)
          points.push_back({width * s / 1000.0, 0.5 * n / 1000.0});

        CellGrid grid(width, 0.5, reach, points.size(), periodic);
        for (std::uint32_t id = 0; id < points.size(); ++id)
          grid.add(id, grid.cellAt(points[id].s, points[id].n));
        for (std::uint32_t id = 0; id < points.size(); ++id)
        {
          const std::set<Sighting> seen = sightings(grid, grid.cellOf(id), {});
          for (std::uint32_t other = 0; other < points.size(); ++other)
            for (int shift = periodic ? -1 : 0; shift <= (periodic ? 1 : 0); ++shift)
            {
              const double ds = points[other].s + shift * width - points[id].s;
              const double dn = points[other].n - points[id].n;
              if (ds * ds + dn * dn < reach * reach)
                RC_ASSERT(seen.count({other, shift}) == 1);
            }
        }
      }));
}

/// One cell takes many more disks than its block can hold, and loses them in any order.
TEST(CellGrid, FollowsASetThroughRandomComingAndGoing)
{
  EXPECT_TRUE(rc::check(
      []
      {
        constexpr std::uint32_t COUNT = 40;
        CellGrid grid(1.0, 1.0, 0.3, COUNT, false);
        std::map<std::uint32_t, int> reference;
        const auto moves = *rc::gen::container<std::vector<std::pair<std::uint32_t, int>>>(
            200, rc::gen::pair(rc::gen::inRange<std::uint32_t>(0, COUNT), rc::gen::inRange(0, 2)));
        for (const auto& [id, column] : moves)
        {
          if (reference.count(id) > 0)
            grid.remove(id);
          if (reference.erase(id) == 0)
          {
            grid.add(id, {column, 0});
            reference[id] = column;
          }
          for (int at : {0, 1})
          {
            std::set<Sighting> expected;
            for (const auto& [there, where] : reference)
              if (where == at)
                expected.emplace(there, 0);
            RC_ASSERT(sightings(grid, {at, 0}, {0, 0, 0, 0}) == expected);
          }
        }
      }));
}

TEST(CellGrid, CellsAreNeverSmallerThanAskedFor)
{
  for (const double side : {0.01, 0.3, 0.9, 1.0})
  {
    const CellGrid grid(1.0, 2.0, side, 100000, true);
    EXPECT_GE(grid.columnStart(1), side);
    EXPECT_GE(grid.rowStart(1), side);
  }
}

TEST(CellGrid, ARingOfOneColumnReachesBeyondItsEndsAndListsEachDiskOnce)
{
  CellGrid ring(1.0, 1.0, 0.6, 2, true, 5);
  ASSERT_EQ(ring.columns(), 1);
  EXPECT_EQ(ring.laps(), 5);
  EXPECT_EQ(ring.leftEdge(0), -5.0);
  EXPECT_EQ(ring.rightEdge(0), 6.0);
  for (std::uint32_t id = 0; id < 2; ++id)
    ring.add(id, ring.cellAt(0.5, 0.5));
  EXPECT_EQ(sightings(ring, ring.cellOf(0), {}), (std::set<Sighting>{{0, 0}, {1, 0}}));
  // With more columns, or open ends, there are no laps.
  EXPECT_EQ(CellGrid(1.0, 1.0, 0.4, 2, true, 5).laps(), 0);
  EXPECT_EQ(CellGrid(1.0, 1.0, 0.6, 2, false, 5).laps(), 0);
}

TEST(CellGrid, NumberOfCellsIsInProportionToTheDisks)
{
  const CellGrid grid(1000.0, 1000.0, 1e-6, 10, true);
  EXPECT_LE(static_cast<double>(grid.columns()) * grid.rows(), 64.0);
}

constexpr double LEAST_SIDE = 0.004;

/// Disks in a rectangular lattice, all at `speed`.
std::vector<BasePoint> lattice(int columns, int rows, double spacing, double speed)
{
  std::vector<BasePoint> points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      points.push_back({{(column + 0.5) * spacing, (row + 0.5) * spacing}, {speed, speed}});
  return points;
}

TEST(CellLayout, ADenseLayerGetsTheSmallestCells)
{
  const auto points = lattice(100, 5, LEAST_SIDE, 0.1);
  const LayoutCosts costs(points, 0.4, 100.0 * 500.0, 0);
  EXPECT_LT(costs.cheapest(LEAST_SIDE).smallest_side, 3.0 * LEAST_SIDE);
}

TEST(CellLayout, AFewFastDisksGetOneCellForAll)
{
  const auto points = lattice(2, 5, 0.1, 10.0);
  const LayoutCosts costs(points, 0.2, 10.0, 64);
  EXPECT_GE(costs.cheapest(LEAST_SIDE).smallest_side, 0.2);
}

TEST(CellLayout, AGasGetsAFewDisksACell)
{
  const auto points = lattice(50, 50, 0.1, 10.0);
  const LayoutCosts costs(points, 5.0, 2.0 * 2500.0, 0);
  const double side = costs.cheapest(LEAST_SIDE).smallest_side;
  EXPECT_GT(side, 0.1);
  EXPECT_LT(side, 1.0);
  EXPECT_LT(costs.of({5.0, side}), 0.5 * costs.of({5.0, 5.0}));
}

TEST(CellLayout, FasterDisksGetLargerCellsBusierOnesSmaller)
{
  const auto slow = lattice(50, 50, 0.1, 1.0);
  const auto fast = lattice(50, 50, 0.1, 30.0);
  const auto side = [](const std::vector<BasePoint>& points, double events)
  { return LayoutCosts(points, 5.0, events, 0).cheapest(LEAST_SIDE).smallest_side; };
  EXPECT_GT(side(fast, 1e4), side(slow, 1e4));
  EXPECT_LT(side(slow, 1e6), side(slow, 1e3));
}

}  // namespace
}  // namespace ratchet_sieve
