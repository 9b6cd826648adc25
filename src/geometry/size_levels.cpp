#include "ratchet_sieve/geometry/size_levels.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// Largest square of the largest diameter, in mean squares, of sizes that are not wide. The candidates of a
/// search are in proportion to it.
constexpr double NARROW = 3.0;

/// Nested cells have to reduce the cost to this fraction.
constexpr double WORTH_NESTING = 0.9;

/// Ratio of the diameters of two levels.
constexpr double STEP = 2.0;

/// Diameters smaller than the largest by more than this factor are not told apart.
constexpr double WIDEST = 4096.0;

/// Area fraction of a layer, typically.
constexpr double DENSITY = 0.7;

/// In units of a pair evaluation: reading a cell without disks; a crossing of a cell's edge, without the
/// pairs beyond it.
constexpr double EVALUATIONS_PER_CELL = 0.4;
constexpr double EVALUATIONS_PER_CROSSING = 20.0;

/// Crossings per other event of a disk in a vibrated layer, with cells of its own diameter.
constexpr double CROSSINGS = 0.4;

/// Area of a circle in squares of its radius.
constexpr double CIRCLE = 3.14;

/// Disks of nearly the same diameter.
struct SizeGroup
{
  double diameter = 0.0;  ///< the largest [m]
  double disks = 0.0;
};

/// By factors of the square root of 2, from the largest down; classes without disks have diameter 0.
std::vector<SizeGroup> classesOf(const std::vector<double>& radii, double largest_diameter)
{
  std::vector<SizeGroup> classes(static_cast<std::size_t>(2.0 * std::log2(WIDEST)) + 1);
  for (const double radius : radii)
  {
    const double step = std::floor(2.0 * std::log2(largest_diameter / (2.0 * radius)));
    SizeGroup& of =
        classes[static_cast<std::size_t>(std::clamp(step, 0.0, static_cast<double>(classes.size() - 1)))];
    of.diameter = std::max(of.diameter, 2.0 * radius);
    of.disks += 1.0;
  }
  return classes;
}

SizeLevels levelsFrom(double smallest, double largest)
{
  SizeLevels levels;
  for (double diameter = smallest; diameter < largest; diameter *= STEP)
    levels.diameters.push_back(diameter);
  levels.diameters.push_back(largest);
  return levels;
}

/// Cost of all disks' events, in pair evaluations. A disk has events in proportion to its perimeter.
double costOf(const SizeLevels& levels, const std::vector<SizeGroup>& classes, double area)
{
  const double side = levels.diameters[0];
  std::vector<double> disks(levels.count());
  double all = 0.0;
  for (const SizeGroup& of : classes)
  {
    disks[levels.of(0.5 * of.diameter)] += of.disks;
    all += of.disks;
  }
  const double mean = std::sqrt(DENSITY * area / all);
  double cost = 0.0;
  for (const SizeGroup& of : classes)
  {
    if (of.disks == 0.0)
      continue;
    const std::size_t level = levels.of(0.5 * of.diameter);
    double evaluations = 0.0;
    for (std::size_t other = 0; other < levels.count(); ++other)
    {
      if (disks[other] == 0.0)
        continue;
      // Cells of the other level, or of the finer grid if that is the own one, out to the reach.
      const double cell = std::min(levels.diameters[other], levels.diameters[level]);
      const double bucket = std::max(side, levels.diameters[other]);
      const double reach = 0.5 * (levels.diameters[other] + of.diameter);
      double region = std::pow(2.0 * reach + side + bucket, 2.0);
      if (other < level)
        region =
            CIRCLE * (std::pow(reach + side, 2.0) - std::pow(std::max(0.0, 0.5 * of.diameter - cell), 2.0));
      region = std::min(region, area);
      evaluations += region * (EVALUATIONS_PER_CELL / (bucket * bucket) + disks[other] / area);
    }
    cost += of.disks * (of.diameter / mean * evaluations +
                        CROSSINGS * mean / side * (EVALUATIONS_PER_CROSSING + evaluations / 3.0));
  }
  return cost;
}

}  // namespace

bool areWide(double largest_diameter, double mean_square_diameter)
{
  return largest_diameter * largest_diameter > NARROW * mean_square_diameter;
}

SizeLevels cheapestLevels(const std::vector<double>& radii, double largest_diameter)
{
  SizeLevels best{{largest_diameter}};
  double squares = 0.0;
  for (const double radius : radii)
    squares += 4.0 * radius * radius;
  if (radii.empty() || !areWide(largest_diameter, squares / static_cast<double>(radii.size())))
    return best;
  const double area = squares / DENSITY;
  const std::vector<SizeGroup> classes = classesOf(radii, largest_diameter);
  double least = WORTH_NESTING * costOf(best, classes, area);
  for (const SizeGroup& of : classes)
  {
    if (of.disks == 0.0)
      continue;
    const SizeLevels levels = levelsFrom(of.diameter, largest_diameter);
    const double cost = costOf(levels, classes, area);
    if (cost >= least)
      continue;
    least = cost;
    best = levels;
  }
  return best;
}

}  // namespace ratchet_sieve
