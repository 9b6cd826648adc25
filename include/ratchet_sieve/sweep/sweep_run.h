#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep.h"
#include "ratchet_sieve/sweep/sweep_results.h"

namespace ratchet_sieve
{

/// How a sweep is run. Each function may be empty.
struct SweepRunOptions
{
  std::size_t threads = 0;            ///< 0: one per processor
  double checkpoint_period = 60.0;    ///< of wall time [s]
  bool retry_failed = false;          ///< run cases again that failed before
  std::function<bool()> stop_wanted;  ///< polled by every thread several times a second
  std::function<void(const SweepProgress&)> progress;
  std::function<void(const std::string&)> warn;  ///< may be called by any thread
  OpenRecord record;                             ///< of cases, which then have no checkpoints
  /// When all runs are to stop, each at its next check, and count for what they have until then.
  std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// The state of a sweep when this process leaves it.
struct SweepOutcome
{
  SweepCounts counts;
  bool stopped = false;
  std::size_t threads = 0;  ///< that ran cases: fewer than wanted, if the system provides no more
  std::size_t threads_wanted = 0;
  /// Of the cases that were stopped, where there is a deadline: the results file has none. A later run
  /// continues them.
  std::vector<CaseResult> cut;
};

/// Runs the cases of a sweep, or of its part, that have no result in the results file at the path. The cases
/// of a killed process are continued. Checkpoints and a lock are in the directory PATH.d: one process at a
/// time writes the file.
/// @throws SceneError before any case is run if one is illegal
/// @throws DatabaseFull if no more results can be stored; earlier results are intact
/// @throws DatabaseError, also if another process runs a sweep into the file
SweepOutcome runSweep(const Sweep& sweep, const std::string& path, const SweepRunOptions& options);

/// Checks that the files of a sweep's parts have no results but of its cases and of this physics version.
/// @return the sweep's cases @throws DatabaseError for the first that has; the message names it @throws
/// SceneError
LegalCases requireMergeable(const Sweep& sweep, const std::vector<std::string>& parts);

/// Copies the results of parts into the sweep's results file. A case that is in several counts once.
/// @param cases requireMergeable() @throws DatabaseError
void mergeResults(const Sweep& sweep, const LegalCases& cases, const std::string& path,
                  const std::vector<std::string>& parts);

/// Says that a system provides fewer threads than wanted.
std::string fewerThreadsText(std::size_t threads, std::size_t wanted);

}  // namespace ratchet_sieve
