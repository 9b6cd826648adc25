#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ratchet_sieve/sweep/best_setting.h"
#include "ratchet_sieve/sweep/case_run.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep.h"
#include "ratchet_sieve/sweep/sweep_plan.h"
#include "ratchet_sieve/sweep/sweep_progress.h"

namespace ratchet_sieve
{

/// How a sweep is run. Each function may be empty.
struct SweepRunOptions
{
  std::size_t threads = 0;            ///< 0: one per processor
  double checkpoint_period = 60.0;    ///< of wall time [s]
  std::size_t per_job = 0;            ///< cases per job of an engine; 0: so that there are at most 1000 jobs
  bool retry_failed = false;          ///< run cases again that failed before
  BestCriteria best;                  ///< criteria for the setting in the progress line
  std::function<bool()> stop_wanted;  ///< polled by every thread several times a second
  std::function<void(const SweepProgress&)> progress;
  std::function<void(const std::string&)> warn;  ///< may be called by any thread
  OpenRecord record;  ///< of cases on threads of this process; they then have no checkpoints
};

/// The state of a sweep when this process leaves it.
struct SweepOutcome
{
  SweepCounts counts;
  bool stopped = false;
  std::size_t threads = 0;  ///< that ran cases: fewer than wanted, if the system provides no more
  std::size_t threads_wanted = 0;
};

/// Runs the cases of a sweep that have no result in the file, on threads of this process. Several processes
/// may run the same sweep: each case is run by one of them. The cases of a killed process are continued by
/// another. Checkpoints and locks are in the directory RESULTS.d.
/// @throws SceneError before any case is run if one is illegal
/// @throws DatabaseFull if no more results can be stored; earlier results are intact
SweepOutcome runSweep(const Sweep& sweep, const std::string& results, const SweepRunOptions& options);

/// The common first and last steps of all ways to run a sweep. The plan is nothing if stopped.
/// @param store is opened @throws SceneError, DatabaseError, OutputError
std::optional<SweepPlan> prepareSweep(const Sweep& sweep, const std::string& results,
                                      std::optional<ResultStore>& store, const SweepRunOptions& options);
void finishSweep(const SweepPlan& plan, ResultStore& store, const Sweep& sweep, const std::string& results);

/// Says that a system provides fewer threads than wanted.
std::string fewerThreadsText(std::size_t threads, std::size_t wanted);

/// The directory of checkpoints and locks.
std::string workDirectory(const std::string& results);

}  // namespace ratchet_sieve
