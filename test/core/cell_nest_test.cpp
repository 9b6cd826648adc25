#include "search/cell_nest.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "search/cell_grid.h"
#include "search/size_levels.h"

namespace ratchet_sieve
{
namespace
{
constexpr double SMALL = 0.001;
constexpr double MARGIN = 1e-5;

/// Disks that wander from cell to cell, with what an event loop has tested: whenever a disk begins a flight
/// or crosses an edge, what visit() shows it.
class Wanderers
{
public:
  Wanderers(CellGrid grid, std::vector<double> radii)
      : grid_(std::move(grid)), radii_(std::move(radii)), images_(radii_.size())
  {
  }

  /// Places all that cover no cell of another.
  void place(const std::vector<std::pair<int, int>>& cells)
  {
    for (std::uint32_t slot = 0; slot < radii_.size(); ++slot)
    {
      const CellGrid::Cell cell{cells[slot].first % grid_.columns(), cells[slot].second % grid_.rows()};
      if (isCovered(slot, cell))
        continue;
      placed_.push_back(slot);
      grid_.add(slot, cell, radii_[slot]);
      test(slot, CellEdge::NONE);
    }
  }

  const std::vector<std::uint32_t>& placed() const { return placed_; }

  void beginFlight(std::uint32_t slot)
  {
    for (auto pair = tested_.begin(); pair != tested_.end();)
      pair = std::get<0>(*pair) == slot || std::get<1>(*pair) == slot ? tested_.erase(pair) : std::next(pair);
    test(slot, CellEdge::NONE);
  }

  /// Into the next cell, unless a wall, or a large disk, is in the way.
  void cross(std::uint32_t slot, CellEdge edge)
  {
    CellGrid::Cell cell = grid_.cellOf(slot);
    cell.column += edge == CellEdge::RIGHT ? 1 : edge == CellEdge::LEFT ? -1 : 0;
    cell.row += edge == CellEdge::UPPER ? 1 : edge == CellEdge::LOWER ? -1 : 0;
    const int laps = cell.column < 0 ? -1 : cell.column >= grid_.columns() ? 1 : 0;
    if (cell.row < 0 || cell.row >= grid_.rows() || (laps != 0 && !grid_.periodic()))
      return;
    cell.column -= laps * grid_.columns();
    if (isCovered(slot, cell))
      return;
    grid_.remove(slot);
    images_[slot] -= laps;
    grid_.add(slot, cell, radii_[slot]);
    test(slot, edge);
  }

  /// Every pair that can touch without leaving its cells has been tested, and nothing else is shown twice.
  void check() const
  {
    for (const std::uint32_t i : placed_)
      for (const std::uint32_t j : placed_)
        for (int shift = grid_.periodic() ? -1 : 0; shift <= (grid_.periodic() ? 1 : 0); ++shift)
        {
          if (i == j)
            continue;
          const auto [columns, rows] = apart(i, grid_.cellOf(i), j, shift);
          const double nearest = std::hypot(std::max(0, columns - 1) * grid_.columnStart(1),
                                            std::max(0, rows - 1) * grid_.rowStart(1));
          if (nearest < radii_[i] + radii_[j])
            RC_ASSERT(tested_.count({i, j, shift + images_[j] - images_[i]}) == 1);
        }
  }

private:
  std::pair<int, int> apart(std::uint32_t /*slot*/, CellGrid::Cell cell, std::uint32_t other, int shift) const
  {
    const CellGrid::Cell there = grid_.cellOf(other);
    return {std::abs(cell.column - there.column - shift * grid_.columns()), std::abs(cell.row - there.row)};
  }

  /// Whether the larger of two would lie over all of the smaller one's cell.
  bool isCovered(std::uint32_t slot, CellGrid::Cell cell) const
  {
    return std::any_of(
        placed_.begin(), placed_.end(),
        [&](std::uint32_t other)
        {
          bool covered = false;
          for (int shift = grid_.periodic() ? -1 : 0; shift <= (grid_.periodic() ? 1 : 0); ++shift)
          {
            const auto [columns, rows] = apart(slot, cell, other, shift);
            covered |= other != slot &&
                       std::hypot((columns + 1) * grid_.columnStart(1), (rows + 1) * grid_.rowStart(1)) <
                           std::max(radii_[slot], radii_[other]);
          }
          return covered;
        });
  }

  void test(std::uint32_t slot, CellEdge entered)
  {
    std::set<std::tuple<std::uint32_t, int>> seen;
    grid_.visit(slot, entered, list_,
                [&](const std::uint32_t* others, std::size_t count, int shift)
                {
                  for (std::size_t k = 0; k < count; ++k)
                  {
                    RC_ASSERT(seen.emplace(others[k], shift).second);
                    const int image = shift + images_[others[k]] - images_[slot];
                    tested_.emplace(slot, others[k], image);
                    tested_.emplace(others[k], slot, -image);
                  }
                });
  }

  CellGrid grid_;
  std::vector<double> radii_;
  std::vector<int> images_;
  std::vector<std::uint32_t> placed_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, int>> tested_;
  std::vector<std::uint32_t> list_;
};

std::vector<double> drawnRadii()
{
  std::vector<double> radii;
  for (const int size : *rc::gen::container<std::vector<int>>(24, rc::gen::inRange(0, 4)))
    radii.push_back(0.5 * SMALL *
                    (size == 0 ? *rc::gen::inRange(20, 240) * 0.1 : *rc::gen::inRange(2, 15) * 0.1));
  return radii;
}

SizeLevels levelsOf(const std::vector<double>& radii)
{
  const double largest = 2.0 * *std::max_element(radii.begin(), radii.end());
  SizeLevels levels;
  for (double diameter = SMALL; diameter < largest; diameter *= *rc::gen::element(1.5, 2.0))
    levels.diameters.push_back(diameter);
  levels.diameters.push_back(largest);
  return levels;
}

TEST(CellNest, WhateverMovesHasTestedEveryPairThatCanTouch)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const std::vector<double> radii = drawnRadii();
        const SizeLevels levels = levelsOf(radii);
        const double width = std::max(levels.largest(), *rc::gen::element(0.02, 0.033, 0.1));
        const double side = levels.diameters[0] + MARGIN;
        const CellShape shape(width, *rc::gen::element(0.01, 0.04), side, 4000);
        Wanderers disks(CellGrid(shape, levels, MARGIN, radii.size(), *rc::gen::arbitrary<bool>()), radii);
        const auto cell = rc::gen::pair(rc::gen::inRange(0, 10000), rc::gen::inRange(0, 10000));
        disks.place(*rc::gen::container<std::vector<std::pair<int, int>>>(radii.size(), cell));
        disks.check();
        for (int step = 0; step < 40; ++step)
        {
          const std::uint32_t slot = disks.placed()[*rc::gen::inRange<std::size_t>(0, disks.placed().size())];
          if (*rc::gen::inRange(0, 4) == 0)
            disks.beginFlight(slot);
          const auto edge =
              *rc::gen::element(CellEdge::LEFT, CellEdge::RIGHT, CellEdge::LOWER, CellEdge::UPPER);
          for (int k = *rc::gen::inRange(1, 12); k > 0; --k)
            disks.cross(slot, edge);
          disks.check();
        }
      }));
}

/// The search of a large disk does not read the cells that it covers, or its cost would grow with its area.
TEST(CellNest, ALargeDiskSeesItsRimOnly)
{
  constexpr double RADIUS = 0.02;
  const SizeLevels levels{{SMALL, 2.0 * RADIUS}};
  const CellShape shape(0.1, 0.1, SMALL + MARGIN, 20000);
  CellGrid grid(shape, levels, MARGIN, 20000, true);
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
