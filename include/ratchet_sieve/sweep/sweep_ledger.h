#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_results.h"

namespace ratchet_sieve
{

/// The directory of checkpoints and of the lock, beside the results file.
std::string workDirectory(const std::string& results);

/// The checkpoint of a case, which holds for one physics version, as a result does; the names of all end with
/// checkpointEnding().
std::string checkpointPath(const std::string& results, const std::string& run_hash);
const std::string& checkpointEnding();

/// Held by the one process that writes a results file. The kernel releases it even if the process is killed.
class ResultsLock
{
public:
  /// Makes the work directory. @throws DatabaseError, also if another process holds the lock
  explicit ResultsLock(const std::string& results);

  /// Removes the work directory if nothing else is in it.
  ~ResultsLock();
  ResultsLock(const ResultsLock&) = delete;
  ResultsLock& operator=(const ResultsLock&) = delete;

  static bool isHeld(const std::string& results);

private:
  std::string directory_;
  int descriptor_ = -1;
};

/// What a run writes to the results file, and the sweep's progress in it. The file lists the cases under way,
/// so that those of a process that died are known. Such a case is suspect until it writes a checkpoint or
/// ends. Suspects come last, and one at a time, so that the one at fault is known by the next death.
class SweepLedger
{
public:
  /// @pre this process holds the ResultsLock
  SweepLedger(const Sweep& sweep, SweepResults& results);

  /// Makes the cases under way suspect, for their process died. @return which failed, because their process
  /// died twice at the same place; empty if none. They get a result. @throws DatabaseError
  std::string recordDeaths();

  /// In one transaction: stores results, and begins up to `wanted` cases without a result, or one suspect.
  /// @return their positions @throws DatabaseError; nothing is changed then
  std::vector<std::uint64_t> exchange(const std::vector<CaseResult>& results, std::size_t wanted);

  /// Forgets the cases under way, which were stopped.
  void forgetUnfinished();

  /// The progress of the sweep. Warnings are counted at intervals.
  SweepProgress progress(std::uint64_t running);

private:
  using Clock = std::chrono::steady_clock;

  std::vector<std::uint64_t> begin(std::size_t most);
  std::vector<std::uint64_t> begin(Statement& select);
  bool runsSuspect();
  std::vector<std::uint64_t> countDeaths();
  std::string placeOf(const std::string& run_hash) const;
  void countWarnings();

  const Sweep& sweep_;
  SweepResults& results_;
  std::int64_t cursor_ = 0;  ///< all positions below have been begun or are suspect
  Statement open_;
  Statement suspect_;
  Statement begin_;
  Statement end_;
  Statement forgive_;
  SweepProgress progress_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_look_ = start_;
};

}  // namespace ratchet_sieve
