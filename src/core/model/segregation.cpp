#include "ratchet_sieve/core/segregation.h"

#include <algorithm>

namespace ratchet_sieve
{

namespace
{
std::optional<double> ratio(double part, double whole)
{
  return whole > 0.0 ? std::optional<double>(part / whole) : std::nullopt;
}
}  // namespace

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

std::vector<SpeciesShares> binShares(const std::vector<SpeciesBins>& bins)
{
  SpeciesBins all;
  for (const SpeciesBins& b : bins)
  {
    all.left += b.left;
    all.right += b.right;
    all.left_mass += b.left_mass;
    all.right_mass += b.right_mass;
  }
  const auto share = [](double part, double bin, double species) {
    return BinShare{ratio(part, bin), ratio(part, species)};
  };
  const auto count = [](std::uint64_t disks) { return static_cast<double>(disks); };
  std::vector<SpeciesShares> shares;
  for (const SpeciesBins& b : bins)
  {
    const double mass = b.left_mass + b.right_mass;
    shares.push_back(
        {{share(count(b.left), count(all.left), count(b.counted())), share(b.left_mass, all.left_mass, mass)},
         {share(count(b.right), count(all.right), count(b.counted())),
          share(b.right_mass, all.right_mass, mass)}});
  }
  return shares;
}

}  // namespace ratchet_sieve
