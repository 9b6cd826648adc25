#include "search/cell_grid.h"

#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

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

        CellGrid grid(CellShape(width, 0.5, reach, points.size(), periodic), {}, 0.0, points.size());
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

}  // namespace
}  // namespace ratchet_sieve
