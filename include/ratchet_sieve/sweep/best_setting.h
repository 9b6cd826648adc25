#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/sweep_plan.h"

namespace ratchet_sieve
{

/// Minimum counts for a setting's Q to be compared with others: with few disks, |s| is large by chance.
struct BestCriteria
{
  double least_processed = 0.5;   ///< P, mean over the seeds
  double least_counted = 50.0;    ///< disks that left, mean over the seeds; for two identical species of 25
                                  ///< disks, Q is 0.11 by chance
  std::vector<Assignment> where;  ///< only settings with these values are compared
};

/// The mean results of one setting over its seeds.
struct SettingMean
{
  std::uint64_t point = 0;      ///< index for Sweep::point()
  std::uint64_t seeds = 0;      ///< number of seeds with a defined separation
  double separation = 0.0;      ///< mean of s over them
  std::optional<double> error;  ///< standard error of that mean; nothing for a single seed
  double processed = 0.0;       ///< mean of P over all completed seeds
  double counted = 0.0;         ///< mean number of disks that left, over all completed seeds

  double quality() const;  ///< |mean s|, which is without the bias of a mean of |s|

  /// Whether the 95 % interval of the mean s leaves 0 out (Student's t over the seeds); nothing without an
  /// error.
  std::optional<bool> separated() const;
};

/// @return nothing if the separation is defined for no seed
std::optional<SettingMean> meanOfSetting(const ResultStore& store, const SweepPlan& plan, const Sweep& sweep,
                                         std::uint64_t point);

/// The setting with the highest |mean s| among those that meet the criteria and whose seeds are all
/// completed.
std::optional<SettingMean> bestSetting(const ResultStore& store, const SweepPlan& plan, const Sweep& sweep,
                                       const BestCriteria& criteria);

/// The swept keys whose smallest or largest value this setting has: a better setting may lie outside the
/// swept range. Only keys with at least three values, all numeric, and not in `where`.
std::vector<std::string> keysAtEdge(const Sweep& sweep, std::uint64_t point,
                                    const std::vector<Assignment>& where);

/// `0.642 +- 0.029 over 12 seeds, P 0.93, 250 disks counted`.
std::string meanText(const SettingMean& mean);

/// One line with the best setting, whether it separates at all, or the reason why there is none; empty if no
/// case has a Q.
std::string bestText(const ResultStore& store, const SweepPlan& plan, const Sweep& sweep,
                     const BestCriteria& criteria, const std::optional<SettingMean>& best);

}  // namespace ratchet_sieve
