#include "ratchet_sieve/core/definition.h"

#include <algorithm>

namespace ratchet_sieve
{

std::vector<OutlineCorner> BaseDefinition::outline() const
{
  if (!profile.empty())
    return profile;
  return {{0.0, 0.0}, {asymmetry * tooth_width, tooth_height}, {tooth_width, 0.0}};
}

double BaseDefinition::highest() const
{
  double height = 0.0;
  for (const OutlineCorner& corner : outline())
    height = std::max(height, corner.n);
  return height;
}

double BaseDefinition::depth() const
{
  double depth = 0.0;
  for (const OutlineCorner& corner : outline())
    depth = std::max(depth, -corner.n);
  return depth;
}

std::optional<double> BaseDefinition::slopeAsymmetry() const
{
  const std::vector<OutlineCorner> corners = outline();
  if (corners.size() != 3 || corners[1].n == 0.0)
    return std::nullopt;
  // The left slope of a groove is the one on its right.
  const double left = corners[1].s / corners[2].s;
  return corners[1].n > 0.0 ? left : 1.0 - left;
}

ContactCoefficients contactBetween(const SceneDefinition& scene, std::size_t first, std::size_t second)
{
  for (const PairDefinition& pair : scene.pairs)
    if ((pair.first == first && pair.second == second) || (pair.first == second && pair.second == first))
      return pair.contact;
  const ContactCoefficients& a = scene.species[first].contact;
  const ContactCoefficients& b = scene.species[second].contact;
  return {0.5 * (a.restitution + b.restitution), 0.5 * (a.friction + b.friction),
          0.5 * (a.tangential_restitution + b.tangential_restitution)};
}

}  // namespace ratchet_sieve
