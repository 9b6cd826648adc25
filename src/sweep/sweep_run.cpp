#include "ratchet_sieve/sweep/sweep_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_ledger.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

/// Interval at which the main thread checks whether to stop and shows the progress, and a thread without a
/// case looks for one.
constexpr auto POLL_PERIOD = std::chrono::milliseconds(100);

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

/// Threads that take a case, run it, and take the next one as they give its result.
class SweepRun
{
public:
  SweepRun(const Sweep& sweep, SweepResults& results, const SweepRunOptions& options)
      : sweep_(sweep), options_(options), results_(results), ledger_(sweep, results)
  {
    makeFolder(workDirectory(results.database().path()));
    removeLeftovers(results);
  }
  ~SweepRun()
  {
    stop_ = true;
    threads_.clear();  // waits for their ends
    try
    {
      ledger_.forgetUnfinished();  // they were stopped, also where an error ends the run
    }
    catch (const DatabaseError&)
    {
      // The next run takes them for those of a process that died.
    }
    std::error_code ignored;  // it stays with the checkpoints in it
    fs::remove(workDirectory(results_.database().path()), ignored);
  }
  SweepRun(const SweepRun&) = delete;
  SweepRun& operator=(const SweepRun&) = delete;

  /// Runs cases in this number of threads, or as many as the system provides, if none in this one.
  /// @return the number of threads
  std::size_t run(std::size_t wanted)
  {
    warn(ledger_.deaths());
    try
    {
      while (threads_.size() < wanted)
        threads_.push_back(std::async(std::launch::async, [this] { serve(); }));
    }
    catch (const std::system_error&)
    {
      warn(fewerThreadsText(std::max<std::size_t>(threads_.size(), 1), wanted));
    }
    if (threads_.empty())
      threads_.push_back(std::async(std::launch::deferred, [this] { serve(); }));
    for (const std::future<void>& thread : threads_)
    {
      while (thread.wait_for(POLL_PERIOD) == std::future_status::timeout)
        look();
      thread.wait();  // where there is no thread, the work is done here
    }
    look();
    requireSuccess();
    return threads_.size();
  }

  /// Once it is so, it stays.
  bool stopWanted()
  {
    if ((options_.stop_wanted && options_.stop_wanted()) ||
        (options_.deadline && std::chrono::steady_clock::now() > *options_.deadline))
      stop_ = true;
    return stop_;
  }

  /// Of the cases that were stopped, once run() has ended.
  std::vector<CaseResult> cut() { return std::move(cut_); }

private:
  /// Whether to stop is asked here as well: it may be that this thread alone can tell.
  void look()
  {
    stopWanted();
    if (!options_.progress)
      return;
    std::unique_lock<std::mutex> lock(mutex_);
    const SweepProgress progress = ledger_.progress();
    lock.unlock();
    options_.progress(progress);
  }

  /// @throws the error that has ended a thread
  void requireSuccess()
  {
    try
    {
      for (std::future<void>& thread : threads_)
        thread.get();
    }
    catch (const DatabaseFull& error)
    {
      throw DatabaseFull(std::string(error.what()) + "; stored results are safe, " +
                         countText(unsaved_, "finished case") +
                         " could not be stored: free some space and start again");
    }
  }

  /// The work of a thread.
  void serve()
  {
    std::optional<CaseResult> result;
    try
    {
      CaseBuilder builder(sweep_);
      while (const std::optional<std::uint64_t> position = exchange(result))
        result = runNext(builder.at(*position));
    }
    catch (...)
    {
      stop_ = true;
      unsaved_ += result ? 1 : 0;
      throw;
    }
  }

  /// Stores a result, if there is one, which is taken. @return the next case; nothing if there is none, or to
  /// stop
  std::optional<std::uint64_t> exchange(std::optional<CaseResult>& result)
  {
    while (true)
    {
      const bool stopping = stopWanted();
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        const std::optional<std::uint64_t> next = ledger_.exchange(result, !stopping);
        if (result)
        {
          std::error_code ignored;
          fs::remove(checkpointPath(results_.database().path(), result->run_hash), ignored);
          result.reset();
        }
        if (next || stopping || !ledger_.waits())
          return next;
      }
      std::this_thread::sleep_for(POLL_PERIOD);
    }
  }

  std::optional<CaseResult> runNext(const SweepCase& next)
  {
    CaseRunOptions options;
    if (!options_.record)
      options.checkpoint = checkpointPath(results_.database().path(), runHash(next.scene));
    options.record = options_.record;
    options.checkpoint_period = options_.checkpoint_period;
    options.stop_wanted = [this] { return stopWanted(); };
    options.warn = options_.warn;
    if (options_.deadline)
      options.take_stopped = [this](const CaseResult& result)
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        cut_.push_back(result);
      };
    return runCase(next, options);
  }

  void warn(const std::string& text) const
  {
    if (options_.warn && !text.empty())
      options_.warn(text);
  }

  const Sweep& sweep_;
  const SweepRunOptions& options_;
  SweepResults& results_;
  std::atomic<bool> stop_{false};
  std::atomic<std::size_t> unsaved_{0};  ///< results lost by an error
  std::mutex mutex_;                     ///< of the ledger, the results and those below
  std::vector<CaseResult> cut_;
  SweepLedger ledger_;
  std::vector<std::future<void>> threads_;
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
                          shownText(select.text(0)));
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
  const std::unique_ptr<SweepResults> results = openResults(sweep, path, options);
  SweepOutcome outcome;
  outcome.stopped = !results;
  if (!results)
    return outcome;
  if (options.retry_failed)
    results->removeFailed();
  outcome.threads_wanted = threadCount(options.threads);
  {
    SweepRun run(sweep, *results, options);
    outcome.threads = run.run(outcome.threads_wanted);
    outcome.stopped = run.stopWanted();
    outcome.cut = run.cut();
  }
  results->fillValues();
  outcome.counts = results->counts();
  if (outcome.counts.open() > 0 && !outcome.stopped)
    throw DatabaseError(path + ": lists other cases than the sweep has: remove it, or use another file");
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
  SweepResults results(sweep, path, Database::Access::WRITE);
  if (!results.isListed())
    results.list(cases);
  for (const std::string& part : parts)
  {
    Transaction transaction(results.database());
    results.copyFrom(ResultStore(part, Database::Access::READ));
    transaction.commit();
  }
  results.fillValues();
}

}  // namespace ratchet_sieve
