#include "ratchet_sieve/seeking/separation.h"

namespace ratchet_sieve
{
namespace
{
double meanBalance(const std::vector<SpeciesBins>& bins)
{
  double sum = 0.0;
  double species = 0.0;
  for (const SpeciesBins& b : bins)
  {
    if (b.counted() == 0)
      continue;
    sum += (static_cast<double>(b.right) - static_cast<double>(b.left)) / static_cast<double>(b.counted());
    species += 1.0;
  }
  return species > 0.0 ? sum / species : 0.0;
}
}  // namespace

Score scoreOf(const Outflow& outflow, const Goal& goal)
{
  return {measured(goal, outflow), measured({}, outflow), meanBalance(outflow.bins)};
}

}  // namespace ratchet_sieve
