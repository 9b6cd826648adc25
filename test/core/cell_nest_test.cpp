#include "search/cell_nest.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "ratchet_sieve/geometry/size_levels.h"
#include "scenes.h"
#include "search/cell_grid.h"

namespace ratchet_sieve
{
namespace
{

constexpr double SMALL = 0.001;
constexpr double MARGIN = 1e-5;

/// The search of a large disk does not read the cells that it covers, or its cost would grow with its area.
TEST(CellNest, ALargeDiskSeesItsRimOnly)
{
  constexpr double RADIUS = 0.02;
  const SizeLevels levels{{SMALL, 2.0 * RADIUS}};
  const CellShape shape(0.1, 0.1, SMALL + MARGIN, 20000, true);
  CellGrid grid(shape, levels, MARGIN, 20000);
  std::uint32_t slot = 0;
  grid.add(slot, grid.cellAt(0.05, 0.05), RADIUS);
  std::size_t rim = 0;
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column)
    {
      const double s = (column + 0.5) * grid.columnStart(1);
      const double n = (row + 0.5) * grid.rowStart(1);
      grid.add(++slot, {column, row}, 0.5 * SMALL);
      rim += std::abs(std::hypot(s - 0.05, n - 0.05) - RADIUS) < 3.0 * SMALL;
    }
  std::vector<std::uint32_t> list;
  std::size_t seen = 0;
  grid.visit(0, CellEdge::NONE, list, [&](const std::uint32_t*, std::size_t count, int) { seen += count; });
  EXPECT_GT(seen, 250u);
  EXPECT_LT(seen, rim);
}

TEST(SizeLevels, AreASingleOneUnlessSizesAreWide)
{
  const auto count = [](std::vector<double> radii, double more, std::size_t of_these)
  {
    radii.insert(radii.end(), of_these, more);
    return cheapestLevels(radii, 2.0 * *std::max_element(radii.begin(), radii.end())).count();
  };
  EXPECT_EQ(count({}, 0.001, 2000), 1u);
  // Figs. 8 and 9.
  EXPECT_EQ(count(std::vector<double>(262, 0.001), 0.002, 262), 1u);
  EXPECT_EQ(count(std::vector<double>(262, 0.001), 0.005, 262), 1u);
  EXPECT_GT(count(std::vector<double>(2000, 0.001), 0.005, 1), 1u);
  EXPECT_GT(count(std::vector<double>(2000, 0.001), 0.05, 1), 1u);
  EXPECT_EQ(cheapestLevels({}, 0.1).count(), 1u);
  // Of same_bits_test.cpp.
  std::vector<double> lognormal;
  for (const SpeciesDefinition& species : test::lognormalSizes(150, 0.5).species)
    lognormal.insert(lognormal.end(), species.count, species.radius);
  EXPECT_GT(count(lognormal, 0.012, 1), 1u);
}

TEST(SizeLevels, HoldEveryDiskInOneThatFits)
{
  EXPECT_TRUE(rc::check(
      []
      {
        std::vector<double> radii;
        for (const int size :
             *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000))))
          radii.push_back(1e-4 * std::pow(10.0, 0.004 * size));
        const double largest =
            2.0 * *std::max_element(radii.begin(), radii.end()) * *rc::gen::element(1.0, 3.0);
        const SizeLevels levels = cheapestLevels(radii, largest);
        RC_ASSERT(levels.largest() == largest);
        RC_ASSERT(std::is_sorted(levels.diameters.begin(), levels.diameters.end()));
        for (const double radius : radii)
        {
          const std::size_t level = levels.of(radius);
          RC_ASSERT(2.0 * radius <= levels.diameters[level]);
          if (level > 0)
            RC_ASSERT(2.0 * radius > levels.diameters[level - 1]);
        }
      }));
}

}  // namespace
}  // namespace ratchet_sieve
