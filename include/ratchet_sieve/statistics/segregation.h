#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ratchet_sieve
{

/// The numbers of disks of one species by place.
struct SpeciesBins
{
  std::uint64_t left = 0;     ///< fallen into the left bin
  std::uint64_t right = 0;    ///< fallen into the right bin
  std::uint64_t on_base = 0;  ///< still in the machine
  double left_mass = 0.0;     ///< of those in the left bin [kg]
  double right_mass = 0.0;    ///< of those in the right bin [kg]

  std::uint64_t counted() const { return left + right; }

  template <typename Archive>
  void archive(Archive& state)
  {
    state(left, right, on_base, left_mass, right_mass);
  }
};

/// What fell into the bins within an interval that ends at the present time.
struct ExitWindow
{
  double start = 0.0;             ///< after this time [s]
  std::vector<SpeciesBins> bins;  ///< per species; on_base is 0
};

/// The separation s of one pair of species, in [-1, 1]: the share of `first` that left on the left less that
/// of `second`. Its mean over runs has no bias.
struct PairSeparation
{
  std::size_t first = 0;
  std::size_t second = 0;

  /// Nothing until at least one disk of each species was counted.
  std::optional<double> separation;
  std::optional<double> by_mass;  ///< the same of masses in place of numbers

  /// Q = |s|: eq. (2) of the paper, max(a_l/N_a + b_r/N_b, a_r/N_a + b_l/N_b) - 1, in [0, 1]. Its mean over
  /// runs is too large: by 0.56 / sqrt(N) for N disks of each of two species that do not separate.
  std::optional<double> quality() const
  {
    return separation ? std::optional<double>(std::abs(*separation)) : std::nullopt;
  }
};

/// Every pair of species, first < second, in order.
std::vector<PairSeparation> pairSeparations(const std::vector<SpeciesBins>& bins);

/// The machine's one pair, or the pair of the largest Q if there are more than two species. Undefined if no
/// pair has a Q.
PairSeparation bestSeparation(const std::vector<SpeciesBins>& bins);

/// P, eq. (3) of the paper: disks in the bins over all disks. Nothing until there was a disk.
std::optional<double> processedRatio(const std::vector<SpeciesBins>& bins);

/// A species in one bin, by number or by mass.
struct BinShare
{
  std::optional<double> purity;    ///< its share of the bin; nothing while the bin is empty
  std::optional<double> recovery;  ///< the bin's share of what left of it; nothing before any of it left
};

/// A species in one bin.
struct BinShares
{
  BinShare number;
  BinShare mass;
};

/// A species in both bins. Of two species, Q is the recovery of one on the left plus that of the other on the
/// right, less 1.
struct SpeciesShares
{
  BinShares left;
  BinShares right;
};

/// Per species.
std::vector<SpeciesShares> binShares(const std::vector<SpeciesBins>& bins);

}  // namespace ratchet_sieve
