#include "ratchet_sieve/seeking/separation.h"

#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// Variance of the fraction of a species that leaves on the right. One disk is added on either side
/// (Laplace's rule): ten of ten do not prove that all of them do.
double shareVariance(const SpeciesBins& bins)
{
  const auto counted = static_cast<double>(bins.counted());
  const double share = (static_cast<double>(bins.right) + 1.0) / (counted + 2.0);
  return share * (1.0 - share) / counted;
}

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

Score scoreOf(const std::vector<SpeciesBins>& bins)
{
  Score score;
  score.balance = meanBalance(bins);
  for (const PairQuality& pair : pairQualities(bins))
  {
    if (!pair.quality || (score.defined && *pair.quality <= score.quality))
      continue;
    score.defined = true;
    score.quality = *pair.quality;
    score.error = std::sqrt(shareVariance(bins[pair.first]) + shareVariance(bins[pair.second]));
  }
  return score;
}

void addBins(std::vector<SpeciesBins>& sum, const std::vector<SpeciesBins>& more)
{
  sum.resize(more.size());
  for (std::size_t k = 0; k < more.size(); ++k)
  {
    sum[k].left += more[k].left;
    sum[k].right += more[k].right;
    sum[k].on_base = more[k].on_base;
  }
}

}  // namespace ratchet_sieve
