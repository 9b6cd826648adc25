#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep.h"
#include "ratchet_sieve/sweep/sweep_plan.h"
#include "ratchet_sieve/sweep/sweep_progress.h"

namespace ratchet_sieve
{

/// How a sweep is run; each function may be empty.
struct SweepRunOptions
{
  std::size_t threads = 0;          ///< 0: as many as there are processors
  double checkpoint_period = 60.0;  ///< of wall time [s]
  std::size_t per_job = 0;    ///< cases that an engine runs in one job; 0: as many as make a thousand jobs
  bool retry_failed = false;  ///< run those again that failed before
  std::function<bool()> stop_wanted;  ///< looked at several times a second, by every thread
  std::function<void(const SweepProgress&)> progress;
  std::function<void(const std::string&)> warn;  ///< called by any thread
};

/// How a sweep stands as this process leaves it.
struct SweepOutcome
{
  SweepCounts counts;
  bool stopped = false;
};

/// Runs the cases of a sweep of which the file has no result, on threads of this process. Other processes may
/// be at the same sweep: each case is run by one of them; what one leaves behind that is killed, another
/// takes up. Checkpoints and locks stand in the directory RESULTS.d.
/// @throws SceneError before any case is run, where one is illegal
/// @throws DatabaseFull where no more results can be taken; those that were are there
SweepOutcome runSweep(const Sweep& sweep, const std::string& results, const SweepRunOptions& options);

/// The steps that every way of running a sweep begins and ends with. The plan is nothing where it was
/// stopped.
/// @param store is opened @throws SceneError, DatabaseError, OutputError
std::optional<SweepPlan> prepareSweep(const Sweep& sweep, const std::string& results,
                                      std::optional<ResultStore>& store, const SweepRunOptions& options);
void finishSweep(const SweepPlan& plan, ResultStore& store, const Sweep& sweep, const std::string& results);

/// Where checkpoints and locks stand.
std::string workDirectory(const std::string& results);

}  // namespace ratchet_sieve
