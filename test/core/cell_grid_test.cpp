#include "search/cell_grid.h"

#include <vector>

#include <gtest/gtest.h>

#include "search/cell_layout.h"

namespace ratchet_sieve
{
namespace
{

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
