#include "ratchet_sieve/sweep/sweep_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/case_pool.h"
#include "ratchet_sieve/sweep/sweep_ledger.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Results are collected for this long, unless a thread waits for work: a transaction costs as much as a
/// small case.
constexpr auto GATHER = std::chrono::milliseconds(20);
/// Interval at which the main thread checks whether to stop.
constexpr auto POLL_PERIOD = std::chrono::milliseconds(100);
/// Work begun in advance for the threads [s]; none if cases take longer, so that few are suspect after a
/// kill.
constexpr double BEGUN_AHEAD = 0.05;
constexpr double MOST_AHEAD = 2000.0;  ///< [cases]
constexpr double RATE_WEIGHT = 0.3;    ///< weight of the newest rate in the running mean

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::size_t threadCount(std::size_t wanted)
{
  return wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

/// Removes checkpoints of cases with a result, which a killed process has left.
void removeLeftovers(const ResultStore& store)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(workDirectory(store.database().path())))
  {
    const std::string name = entry.path().filename().string();
    const std::size_t dot = name.find(checkpointEnding());
    std::error_code ignored;
    if (dot != std::string::npos && store.statusOf(name.substr(0, dot)))
      fs::remove(entry.path(), ignored);
  }
}

class SweepRun
{
public:
  SweepRun(const Sweep& sweep, SweepResults& results, const SweepRunOptions& options)
      : options_(options),
        results_(results),
        ledger_(sweep, results),
        threads_wanted_(threadCount(options.threads)),
        pool_(threads_wanted_, [this, &sweep] { return makeWork(sweep); })
  {
  }
  ~SweepRun() { stop_ = true; }
  SweepRun(const SweepRun&) = delete;
  SweepRun& operator=(const SweepRun&) = delete;

  std::size_t threads() const { return pool_.threads(); }
  std::size_t threadsWanted() const { return threads_wanted_; }

  /// @return whether it was stopped
  bool run()
  {
    if (threads() < threads_wanted_ && options_.warn)
      options_.warn(fewerThreadsText(threads(), threads_wanted_));
    if (const std::string text = ledger_.recordDeaths(); !text.empty() && options_.warn)
      options_.warn(text);
    try
    {
      runAll();
    }
    catch (const DatabaseFull& error)
    {
      giveUp(error.what());
    }
    ledger_.forgetUnfinished();
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
      if (!options_.record)
        options.checkpoint = checkpointPath(results_.database().path(), runHash(next.scene));
      options.record = options_.record;
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
      if (pool_.unfinished() == 0)
      {
        if (!stopping)
          requireAllRun();
        return;
      }
      takeFinished();
    }
  }

  std::size_t wanted() const
  {
    const double ahead = std::min(rate_ * BEGUN_AHEAD, MOST_AHEAD);
    const std::size_t target = pool_.threads() + static_cast<std::size_t>(ahead);
    return target - std::min(target, pool_.unfinished());
  }

  void takeFinished()
  {
    std::vector<FinishedCase> finished = pool_.take(GATHER, POLL_PERIOD);
    for (FinishedCase& each : finished)
      if (each.result)
        unsaved_.push_back(std::move(*each.result));
  }

  /// Stores finished cases, and begins new ones.
  void exchange(std::size_t wanted)
  {
    if (unsaved_.empty() && wanted == 0)
      return;
    pool_.give(ledger_.exchange(unsaved_, wanted));
    forgetSaved();
  }

  void forgetSaved()
  {
    for (const CaseResult& result : unsaved_)
    {
      std::error_code ignored;
      fs::remove(checkpointPath(results_.database().path(), result.run_hash), ignored);
    }
    const double interval = secondsSince(last_saved_);
    if (interval > 0.0)
      rate_ += RATE_WEIGHT * (static_cast<double>(unsaved_.size()) / interval - rate_);
    last_saved_ = Clock::now();
    unsaved_.clear();
  }

  void showProgress()
  {
    const std::size_t running = pool_.unfinished() - std::min(pool_.unfinished(), pool_.waiting());
    if (options_.progress)
      options_.progress(ledger_.progress(running));
  }

  /// @throws DatabaseError if the hash of a case was another than in the file
  void requireAllRun()
  {
    if (results_.counts().open() > 0)
      throw DatabaseError(results_.database().path() +
                          ": lists other cases than the sweep has: remove it, or use another file");
  }

  /// Stops the threads, and tries once more to store the finished cases.
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
      // Reported below, with the number of cases affected.
    }
    throw DatabaseFull(reason + "; stored results are safe, " + countText(unsaved_.size(), "finished case") +
                       " could not be stored: free some space and start again");
  }

  const SweepRunOptions& options_;
  SweepResults& results_;
  SweepLedger ledger_;
  std::vector<CaseResult> unsaved_;
  double rate_ = 0.0;  ///< running mean [cases/s]
  Clock::time_point last_saved_ = Clock::now();
  std::atomic<bool> stop_{false};
  std::size_t threads_wanted_;
  CasePool pool_;  ///< last, because its threads use the other members
};

/// @throws DatabaseError for a result that is not of the sweep's cases @param planned their run_hash
void requirePlanned(const ResultStore& part, const std::set<std::string>& planned, const Sweep& sweep)
{
  const std::string& path = part.database().path();
  Statement select(part.database(), "SELECT run_hash, MAX(physics = ?) FROM cases GROUP BY run_hash",
                   {PHYSICS_VERSION});
  while (select.step())
  {
    if (planned.count(select.text(0)) == 0)
      throw DatabaseError(path + ": has a result of no case of " + sweep.source + ": run_hash " +
                          select.text(0));
    if (select.integer(1) == 0)
      throw DatabaseError(path + ": has a result of another physics version than " +
                          std::to_string(PHYSICS_VERSION) + ": run_hash " + select.text(0));
  }
}

/// Opens a results file, or a new one. Illegal cases are found before anything is written.
/// @return nothing if stopped @throws SceneError, DatabaseError
std::unique_ptr<SweepResults> openResults(const Sweep& sweep, const std::string& path,
                                          const SweepRunOptions& options)
{
  const auto open = [&] { return std::make_unique<SweepResults>(sweep, path, Database::Access::WRITE); };
  std::unique_ptr<SweepResults> results = fs::exists(path) ? open() : nullptr;
  if (results && results->isListed())
    return results;
  const std::optional<LegalCases> cases = legalCases(sweep, options.stop_wanted);
  if (!cases)
    return nullptr;
  if (options.warn)
    for (const std::string& line : cases->warnings.lines(sweep.size(), "case"))
      options.warn(line);
  if (!results)
    results = open();
  results->list(*cases);
  return results;
}

}  // namespace

std::string fewerThreadsText(std::size_t threads, std::size_t wanted)
{
  return countText(threads, "thread") + " of " + std::to_string(wanted) +
         " could be started; the results are the same";
}

SweepOutcome runSweep(const Sweep& sweep, const std::string& path, const SweepRunOptions& options)
{
  const ResultsLock lock(path);
  const std::unique_ptr<SweepResults> results = openResults(sweep, path, options);
  if (!results)
    return {{}, true};
  removeLeftovers(results->store());
  if (options.retry_failed)
    results->removeFailed();
  SweepOutcome outcome;
  {
    SweepRun run(sweep, *results, options);
    outcome.threads = run.threads();
    outcome.threads_wanted = run.threadsWanted();
    outcome.stopped = run.run();
  }
  results->fillValues();
  outcome.counts = results->counts();
  return outcome;
}

LegalCases requireMergeable(const Sweep& sweep, const std::vector<std::string>& parts)
{
  LegalCases cases = *legalCases(sweep);
  const std::set<std::string> planned(cases.run_hashes.begin(), cases.run_hashes.end());
  for (const std::string& part : parts)
    requirePlanned(ResultStore(part, Database::Access::READ), planned, sweep);
  return cases;
}

void mergeResults(const Sweep& sweep, const LegalCases& cases, const std::string& path,
                  const std::vector<std::string>& parts)
{
  const ResultsLock lock(path);
  SweepResults results(sweep, path, Database::Access::WRITE);
  if (!results.isListed())
    results.list(cases);
  for (const std::string& part : parts)
  {
    Transaction transaction(results.database());
    results.store().copyFrom(ResultStore(part, Database::Access::READ));
    transaction.commit();
  }
  results.fillValues();
}

}  // namespace ratchet_sieve
