#include "ratchet_sieve/sweep/engine_run.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_file.h"
#include "ratchet_sieve/sweep/sweep_ledger.h"
#include "result_intake.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

/// Interval at which the coordinator looks for results.
constexpr auto LOOK_AROUND = std::chrono::milliseconds(200);

/// Largest number of files per round: the default limit of a Slurm array, and small enough for a directory.
constexpr std::size_t MOST_FILES = 1000;

class EngineRun
{
public:
  EngineRun(SweepEngine& engine, const Sweep& sweep, ResultStore& store, const SweepPlan& plan,
            const std::string& directory, const SweepRunOptions& options)
      : engine_(engine),
        options_(options),
        builder_(sweep),
        ledger_(sweep, store, plan, directory),
        folder_(jobFolder(fs::absolute(directory).string(), ledger_.claims().owner())),
        intake_(sweep, plan, store, directory, options.warn)
  {
  }

  /// @return whether it was stopped
  bool run()
  {
    ledger_.claims().freeAbandoned();
    while (!stopWanted() && ledger_.countOpen() > 0)
      if (!round())
      {
        ledger_.claims().sayOthers(options_.warn);
        std::this_thread::sleep_for(LOOK_AROUND);
      }
    std::error_code ignored;  // a late job may be writing into it
    if (!stopWanted())
      fs::remove_all(folder_, ignored);
    return stopWanted();
  }

private:
  bool stopWanted() const { return options_.stop_wanted && options_.stop_wanted(); }

  /// Submits all missing cases that no other process has claimed, and waits until the engine has ended.
  /// @return whether there were any
  bool round()
  {
    intake_.takeAbandoned();
    const std::vector<std::uint64_t> positions = claim();
    if (positions.empty())
      return false;
    const std::uint64_t before = ledger_.countOpen();
    fs::create_directories(folder_);
    engine_.start(folder_, writeCases(positions));
    running_ = positions.size();
    try
    {
      awaitEngine();
    }
    catch (...)
    {
      engine_.stop();
      throw;
    }
    ledger_.claims().releaseAll();
    if (ledger_.countOpen() == before && !stopWanted())
      throw EngineError("no result came back; " + folder_ + "/log says why");
    return true;
  }

  std::vector<std::uint64_t> claim()
  {
    ledger_.claims().freeAbandoned();
    return ledger_.exchange({}, ledger_.countOpen());
  }

  void awaitEngine()
  {
    bool stopped = false;
    while (engine_.isRunning())
    {
      gather();
      if (stopWanted() && !stopped)
        engine_.stop();
      stopped = stopWanted();
      std::this_thread::sleep_for(LOOK_AROUND);
    }
    gather();
  }

  /// @return the names of the files
  std::vector<std::string> writeCases(const std::vector<std::uint64_t>& positions)
  {
    const std::size_t per_file = std::max(options_.per_job, (positions.size() + MOST_FILES - 1) / MOST_FILES);
    std::vector<std::string> names;
    std::vector<SweepCase> cases;
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
      cases.push_back(builder_.at(positions[k]));
      if (cases.size() < per_file && k + 1 < positions.size())
        continue;
      names.push_back(fmt::format("{:04}.case", names.size()));
      writeCaseFile(folder_ + '/' + names.back(), cases);
      cases.clear();
    }
    return names;
  }

  /// Stores the results that have arrived, and removes their files.
  void gather()
  {
    const std::vector<CaseResult> results = intake_.take(folder_);
    ledger_.count(results);
    running_ -= std::min<std::uint64_t>(running_, results.size());
    if (options_.progress)
      options_.progress(ledger_.progress(running_, options_.best));
  }

  SweepEngine& engine_;
  const SweepRunOptions& options_;
  CaseBuilder builder_;
  SweepLedger ledger_;
  std::string folder_;  ///< of this process alone
  ResultIntake intake_;
  std::uint64_t running_ = 0;  ///< submitted and not returned
};

}  // namespace

SweepOutcome runSweepOn(SweepEngine& engine, const Sweep& sweep, const std::string& results,
                        const SweepRunOptions& options)
{
  std::optional<ResultStore> store;
  const std::optional<SweepPlan> plan = prepareSweep(sweep, results, store, options);
  if (!plan)
    return {{}, true};
  SweepOutcome outcome;
  outcome.stopped = EngineRun(engine, sweep, *store, *plan, workDirectory(results), options).run();
  finishSweep(*plan, *store, sweep, results);
  outcome.counts = plan->counts(store->database());
  return outcome;
}

}  // namespace ratchet_sieve
