#include "ratchet_sieve/sweep/sweep_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_claims.h"
#include "ratchet_sieve/sweep/case_pool.h"
#include "ratchet_sieve/sweep/case_run.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Results are gathered for so long, while no thread waits for work: a transaction costs as much as a small
/// case.
constexpr auto GATHER = std::chrono::milliseconds(20);
/// So often the coordinator looks whether it is to stop, and whether others have left something behind.
constexpr auto LOOK_AROUND = std::chrono::milliseconds(100);
/// Work for so long is claimed ahead of the threads [s]. Nothing, where cases take longer: another process
/// may come.
constexpr double CLAIMED_AHEAD = 0.05;
constexpr double MOST_AHEAD = 2000.0;  ///< [cases]
constexpr double RATE_WEIGHT = 0.3;    ///< of the newest rate in the running mean

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::size_t threadCount(std::size_t wanted)
{
  return wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

std::string makeDirectory(const std::string& path)
{
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw OutputError(path + ": cannot be made: " + error.message());
  return path;
}

/// A case's checkpoint is of one version of the physics, as its result is.
const std::string CHECKPOINT = ".physics" + std::to_string(PHYSICS_VERSION) + ".checkpoint";

std::string checkpointPath(const std::string& directory, const std::string& run_hash)
{
  return directory + '/' + run_hash + CHECKPOINT;
}

/// Checkpoints of cases of which there is a result: what a process had no time to remove.
void removeLeftovers(const Database& database, const std::string& directory)
{
  Statement select(database, "SELECT 1 FROM cases WHERE run_hash = ? AND physics = ?");
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
  {
    const std::string name = entry.path().filename().string();
    const std::size_t dot = name.find(CHECKPOINT);
    if (dot == std::string::npos)
      continue;
    std::error_code ignored;
    if (select.bind(1, name.substr(0, dot)).bind(2, PHYSICS_VERSION).step())
      fs::remove(entry.path(), ignored);
    select.reset();
  }
}

class SweepRun
{
public:
  SweepRun(const Sweep& sweep, ResultStore& store, const SweepPlan& plan, const std::string& directory,
           const SweepRunOptions& options)
      : options_(options),
        directory_(directory),
        store_(store),
        plan_(plan),
        keys_(sweep.keys()),
        claims_(store.database(), plan, directory),
        threads_(threadCount(options.threads)),
        pool_(threads_, [this, &sweep] { return makeWork(sweep); })
  {
    const SweepCounts counts = plan.counts(store.database());
    progress_.cases = counts.cases;
    progress_.done = counts.done;
    progress_.failed = counts.failed;
    if (const std::optional<BestCase> best = plan.best(store))
      progress_.best_quality = best->quality;
  }
  ~SweepRun() { stop_ = true; }
  SweepRun(const SweepRun&) = delete;
  SweepRun& operator=(const SweepRun&) = delete;

  /// @return whether it was stopped
  bool run()
  {
    try
    {
      runAll();
    }
    catch (const DatabaseFull& error)
    {
      giveUp(error.what());
    }
    claims_.releaseAll();
    return stopWanted();
  }

private:
  CasePool::Work makeWork(const Sweep& sweep)
  {
    const auto builder = std::make_shared<CaseBuilder>(sweep);
    return [this, builder](std::uint64_t position) -> std::optional<CaseResult>
    {
      if (stopWanted())
        return std::nullopt;
      const SweepCase& next = builder->at(position);
      CaseRunOptions options;
      options.checkpoint = checkpointPath(directory_, runHash(next.scene));
      options.checkpoint_period = options_.checkpoint_period;
      options.stop_wanted = [this] { return stopWanted(); };
      options.warn = options_.warn;
      return runCase(next, options);
    };
  }

  bool stopWanted() const { return stop_ || (options_.stop_wanted && options_.stop_wanted()); }

  void runAll()
  {
    while (true)
    {
      const bool stopping = stopWanted();
      exchange(stopping ? 0 : wanted());
      showProgress();
      if (pool_.unfinished() == 0 && (stopping || isThrough()))
        return;
      takeFinished();
    }
  }

  std::size_t wanted() const
  {
    const double ahead = std::min(rate_ * CLAIMED_AHEAD, MOST_AHEAD);
    const std::size_t target = threads_ + static_cast<std::size_t>(ahead);
    return target - std::min(target, pool_.unfinished());
  }

  void takeFinished()
  {
    std::vector<FinishedCase> finished = pool_.take(GATHER, LOOK_AROUND);
    for (FinishedCase& each : finished)
      if (each.result)
        unsaved_.push_back(std::move(*each.result));
  }

  /// Writes down what is finished, and claims what comes next.
  void exchange(std::size_t wanted)
  {
    if (unsaved_.empty() && wanted == 0)
      return;
    std::vector<std::uint64_t> positions;
    try
    {
      Transaction transaction(store_.database());
      for (const CaseResult& result : unsaved_)
      {
        store_.record(keys_, result);
        claims_.release(result.run_hash);
      }
      if (wanted > 0)
        positions = claims_.take(wanted);
      transaction.commit();
    }
    catch (const DatabaseError&)
    {
      store_.forgetColumns();
      throw;
    }
    pool_.give(positions);
    countSaved();
  }

  void countSaved()
  {
    for (const CaseResult& result : unsaved_)
    {
      ++(result.error.empty() ? progress_.done : progress_.failed);
      if (result.summary.contains("quality") && result.summary["quality"].is_number())
        progress_.best_quality =
            std::max(progress_.best_quality.value_or(0.0), result.summary["quality"].get<double>());
      std::error_code ignored;
      fs::remove(checkpointPath(directory_, result.run_hash), ignored);
    }
    const double interval = secondsSince(last_saved_);
    if (interval > 0.0)
      rate_ += RATE_WEIGHT * (static_cast<double>(unsaved_.size()) / interval - rate_);
    last_saved_ = Clock::now();
    progress_.finished_here += unsaved_.size();
    unsaved_.clear();
  }

  void showProgress()
  {
    progress_.running = pool_.unfinished() - std::min(pool_.unfinished(), pool_.waiting());
    progress_.wall = secondsSince(start_);
    if (options_.progress)
      options_.progress(progress_);
  }

  /// Whether there is nothing left: not with this process, nor with another, which may yet be killed.
  bool isThrough() { return claims_.freeAbandoned() == 0 && plan_.counts(store_.database()).open() == 0; }

  /// Stops the threads, and tries once more to write down what is finished.
  [[noreturn]] void giveUp(const std::string& reason)
  {
    stop_ = true;
    while (pool_.unfinished() > 0)
      takeFinished();
    try
    {
      exchange(0);
    }
    catch (const DatabaseFull&)
    {
      // Said below, with how many it concerns.
    }
    throw DatabaseFull(reason + "; what it holds is safe, " + std::to_string(unsaved_.size()) +
                       " finished cases found no room: make room and start again, it goes on");
  }

  const SweepRunOptions& options_;
  std::string directory_;
  ResultStore& store_;
  const SweepPlan& plan_;
  std::vector<std::string> keys_;
  CaseClaims claims_;
  std::vector<CaseResult> unsaved_;
  SweepProgress progress_;
  double rate_ = 0.0;  ///< running mean [cases/s]
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_saved_ = start_;
  std::atomic<bool> stop_{false};
  std::size_t threads_;
  CasePool pool_;  ///< last: its threads use the others
};

/// The plan that the file has, or else a new one: what is illegal is found before anything is written.
std::optional<SweepPlan> findOrMakePlan(const Sweep& sweep, const std::string& results,
                                        std::optional<ResultStore>& store, const SweepRunOptions& options)
{
  if (fs::exists(results))
  {
    store.emplace(results, Database::Access::WRITE);
    if (std::optional<SweepPlan> plan = SweepPlan::find(store->database(), sweep))
      return plan;
  }
  requireLegal(sweep);
  if (!store)
    store.emplace(results, Database::Access::WRITE);
  return SweepPlan::make(store->database(), sweep, options.stop_wanted);
}

}  // namespace

std::string workDirectory(const std::string& results)
{
  return results + ".d";
}

std::optional<SweepPlan> prepareSweep(const Sweep& sweep, const std::string& results,
                                      std::optional<ResultStore>& store, const SweepRunOptions& options)
{
  const std::optional<SweepPlan> plan = findOrMakePlan(sweep, results, store, options);
  if (plan && options.retry_failed)
    plan->removeFailed(store->database());
  if (plan)
    removeLeftovers(store->database(), makeDirectory(workDirectory(results)));
  return plan;
}

void finishSweep(const SweepPlan& plan, ResultStore& store, const Sweep& sweep, const std::string& results)
{
  plan.fillValues(store, sweep);
  std::error_code ignored;
  fs::remove(workDirectory(results), ignored);  // where it is empty
}

SweepOutcome runSweep(const Sweep& sweep, const std::string& results, const SweepRunOptions& options)
{
  std::optional<ResultStore> store;
  const std::optional<SweepPlan> plan = prepareSweep(sweep, results, store, options);
  if (!plan)
    return {{}, true};
  SweepOutcome outcome;
  outcome.stopped = SweepRun(sweep, *store, *plan, workDirectory(results), options).run();
  finishSweep(*plan, *store, sweep, results);
  outcome.counts = plan->counts(store->database());
  return outcome;
}

}  // namespace ratchet_sieve
