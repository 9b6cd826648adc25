#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

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
