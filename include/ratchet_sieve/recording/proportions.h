#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/recording/estimates.h"

namespace ratchet_sieve
{

/// The ends of an interval of a proportion.
struct ProportionInterval
{
  double low = 0.0;
  double high = 1.0;
};

/// E. B. Wilson, J. Am. Stat. Assoc. 22, 209 (1927), doi:10.1080/01621459.1927.10502953: it has a width also
/// where none or all of the count are in the part.
/// @param z half-width over the standard error
ProportionInterval wilsonInterval(double share, double count, double z);

/// A part of the disks that left, in blocks: the part as the sum, all of them as the weight.
struct Portion
{
  std::vector<BlockSum> number;
  std::vector<BlockSum> mass;  ///< [kg]
};

/// The factor by which the count of independent disks would be smaller for an error as large as that of the
/// blocks, which are correlated: 1 at least. Nothing where none or all are in the part, and of a series too
/// short for an error.
std::optional<double> correlationOf(const Portion& portion, double confidence);

/// By number and by mass; nothing if nothing left.
struct PortionEstimates
{
  std::optional<Estimate> number;
  std::optional<Estimate> mass;
};

/// What share the part is. The half-width is the distance to the farther end of Wilson's interval of as many
/// independent disks (correlationOf()), so that it is not 0. By mass the interval's ends are those by number
/// with the mean masses of the part's disks and of the others, but not narrower than the error of the blocks.
/// @param correlation where the portion's own is unknown
/// @param part_mass, rest_mass mean mass of a disk of the part and of the others, where there is none [kg]
PortionEstimates portionEstimates(const Portion& portion, double correlation, double part_mass,
                                  double rest_mass, double confidence);

}  // namespace ratchet_sieve
