#include "ratchet_sieve/core/segregation.h"

#include <algorithm>

namespace ratchet_sieve
{

std::optional<double> segregationQuality(const SpeciesBins& a, const SpeciesBins& b)
{
  if (a.counted() == 0 || b.counted() == 0)
    return std::nullopt;
  const auto share = [](std::uint64_t part, const SpeciesBins& of)
  { return static_cast<double>(part) / static_cast<double>(of.counted()); };
  return std::max(share(a.left, a) + share(b.right, b), share(a.right, a) + share(b.left, b)) - 1.0;
}

std::vector<PairQuality> pairQualities(const std::vector<SpeciesBins>& bins)
{
  std::vector<PairQuality> qualities;
  for (std::size_t i = 0; i < bins.size(); ++i)
    for (std::size_t j = i + 1; j < bins.size(); ++j)
      qualities.push_back({i, j, segregationQuality(bins[i], bins[j])});
  return qualities;
}

std::optional<double> bestQuality(const std::vector<SpeciesBins>& bins)
{
  std::optional<double> best;
  for (const PairQuality& pair : pairQualities(bins))
    if (pair.quality && (!best || *pair.quality > *best))
      best = pair.quality;
  return best;
}

std::optional<double> processedRatio(const std::vector<SpeciesBins>& bins)
{
  std::uint64_t counted = 0;
  std::uint64_t all = 0;
  for (const SpeciesBins& b : bins)
  {
    counted += b.counted();
    all += b.counted() + b.on_base;
  }
  if (counted == 0)
    return std::nullopt;
  return static_cast<double>(counted) / static_cast<double>(all);
}

}  // namespace ratchet_sieve
