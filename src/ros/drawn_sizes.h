#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ratchet_sieve/core/sizes.h"

namespace ratchet_sieve
{

/// The lists of spheres in which the disks are drawn: RViz draws all spheres of a list at one size. One for
/// each species, and more for a species that has sizes, so that each disk is drawn within 2 % of its size.
class DrawnSizes
{
public:
  struct List
  {
    std::size_t species;
    double radius;  ///< drawn [m]
  };

  explicit DrawnSizes(const SceneDefinition& scene)
  {
    for (std::size_t k = 0; k < scene.species.size(); ++k)
    {
      const Sizes sizes(scene.species[k]);
      const double steps = std::ceil(std::log(sizes.largest() / sizes.smallest()) / STEP);
      first_.push_back({lists_.size(), sizes.smallest(), steps});
      for (int step = 0; step <= static_cast<int>(steps); ++step)
        lists_.push_back({k, sizes.smallest() * std::exp(step * STEP)});
    }
  }

  const std::vector<List>& lists() const { return lists_; }

  std::size_t listOf(std::size_t species, double radius) const
  {
    const First& first = first_[species];
    const double step = std::round(std::log(radius / first.smallest) / STEP);
    return first.list + static_cast<std::size_t>(std::clamp(step, 0.0, first.steps));
  }

private:
  /// The first list of a species.
  struct First
  {
    std::size_t list;
    double smallest;  ///< [m]
    double steps;
  };

  static constexpr double STEP = 0.04;  ///< of the logarithm of the radius

  std::vector<List> lists_;
  std::vector<First> first_;  ///< per species
};

}  // namespace ratchet_sieve
