#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/best_setting.h"
#include "ratchet_sieve/sweep/case_claims.h"
#include "ratchet_sieve/sweep/case_result.h"
#include "ratchet_sieve/sweep/sweep_progress.h"

namespace ratchet_sieve
{

/// The coordinator's writes to the results file, and the sweep's progress in it.
class SweepLedger
{
public:
  /// @param directory of the locks
  SweepLedger(const Sweep& sweep, ResultStore& store, const SweepPlan& plan, const std::string& directory);

  CaseClaims& claims() { return claims_; }

  /// In one transaction: stores results, releases their claims, and claims new cases.
  /// @param wanted largest number of cases to claim @return their positions @throws DatabaseError; nothing is
  /// changed then
  std::vector<std::uint64_t> exchange(const std::vector<CaseResult>& results, std::size_t wanted);

  /// Stores a failed result for each case whose process died twice at the same place, and releases the other
  /// cases of dead processes. @return which cases failed so; empty if none @throws DatabaseError
  std::string recordDeaths();

  /// Counts results that other processes have stored for this one.
  void count(const std::vector<CaseResult>& results);

  /// Counts the cases without a result. Other processes may have changed the number, so it is counted anew.
  std::uint64_t countOpen();

  /// The progress of the sweep. Warnings and the best setting are updated at intervals.
  SweepProgress progress(std::uint64_t running, const BestCriteria& criteria);

private:
  using Clock = std::chrono::steady_clock;

  void lookAtResults(const BestCriteria& criteria);

  const Sweep& sweep_;
  ResultStore& store_;
  const SweepPlan& plan_;
  CaseClaims claims_;
  SweepProgress progress_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_look_ = start_;
};

}  // namespace ratchet_sieve
