#include "ratchet_sieve/statistics/segregation.h"

namespace ratchet_sieve
{

namespace
{
std::optional<double> ratio(double part, double whole)
{
  return whole > 0.0 ? std::optional<double>(part / whole) : std::nullopt;
}

std::optional<double> difference(std::optional<double> a, std::optional<double> b)
{
  return a && b ? std::optional<double>(*a - *b) : std::nullopt;
}
}  // namespace

std::vector<PairSeparation> pairSeparations(const std::vector<SpeciesBins>& bins)
{
  const std::vector<SpeciesShares> shares = binShares(bins);
  std::vector<PairSeparation> pairs;
  for (std::size_t i = 0; i < bins.size(); ++i)
    for (std::size_t j = i + 1; j < bins.size(); ++j)
      pairs.push_back({i, j, difference(shares[i].left.number.recovery, shares[j].left.number.recovery),
                       difference(shares[i].left.mass.recovery, shares[j].left.mass.recovery)});
  return pairs;
}

PairSeparation bestSeparation(const std::vector<SpeciesBins>& bins)
{
  PairSeparation best;
  for (const PairSeparation& pair : pairSeparations(bins))
    if (pair.separation && (!best.separation || *pair.quality() > *best.quality()))
      best = pair;
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
