#include "ratchet_sieve/sweep/engine_run.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_claims.h"
#include "ratchet_sieve/sweep/case_file.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// So often the coordinator looks for results.
constexpr auto LOOK_AROUND = std::chrono::milliseconds(200);

/// Most files of a round: as many tasks as an array of Slurm has by default, and few enough for a directory.
constexpr std::size_t MOST_FILES = 1000;

class EngineRun
{
public:
  EngineRun(Engine& engine, const Sweep& sweep, ResultStore& store, const SweepPlan& plan,
            const std::string& directory, const SweepRunOptions& options)
      : engine_(engine),
        options_(options),
        directory_(fs::absolute(directory + "/cases").string()),
        keys_(sweep.keys()),
        builder_(sweep),
        store_(store),
        plan_(plan),
        claims_(store.database(), plan, directory)
  {
    const SweepCounts counts = plan.counts(store.database());
    progress_.cases = counts.cases;
    progress_.done = counts.done;
    progress_.failed = counts.failed;
    if (const std::optional<BestCase> best = plan.best(store))
      progress_.best_quality = best->quality;
  }

  /// @return whether it was stopped
  bool run()
  {
    // What an earlier coordinator had no time to gather.
    fs::create_directories(directory_);
    gather();
    while (!stopWanted() && plan_.counts(store_.database()).open() > 0)
    {
      const std::uint64_t before = progress_.finished_here;
      round();
      if (!stopWanted() && progress_.finished_here == before)
        throw EngineError("no result came back; " + directory_ + "/log says why");
    }
    if (!stopWanted())
      fs::remove_all(directory_);
    return stopWanted();
  }

private:
  bool stopWanted() const { return options_.stop_wanted && options_.stop_wanted(); }

  /// Hands everything over that is missing, and waits until the engine has ended.
  void round()
  {
    claims_.freeAbandoned();
    std::vector<std::uint64_t> positions;
    {
      Transaction transaction(store_.database());
      positions = claims_.take(plan_.counts(store_.database()).open());
      transaction.commit();
    }
    progress_.running = positions.size();
    if (!positions.empty())
      engine_.start(directory_, writeCases(positions));
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
    claims_.releaseAll();
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
      writeCaseFile(directory_ + '/' + names.back(), cases);
      cases.clear();
    }
    return names;
  }

  /// Takes what has come into the table, and out of the directory.
  void gather()
  {
    for (const fs::directory_entry& entry : fs::directory_iterator(directory_))
      if (entry.path().extension() == ".results")
        take(entry.path());
    progress_.wall = std::chrono::duration<double>(Clock::now() - start_).count();
    if (options_.progress)
      options_.progress(progress_);
  }

  void take(const fs::path& path)
  {
    std::vector<CaseResult> results;
    try
    {
      results = readResultFile(path.string());
    }
    catch (const CaseFileError& error)
    {
      if (options_.warn)
        options_.warn(std::string(error.what()) + "; its cases run again");
    }
    {
      Transaction transaction(store_.database());
      for (const CaseResult& result : results)
      {
        store_.record(keys_, result);
        claims_.release(result.run_hash);
      }
      transaction.commit();
    }
    for (const CaseResult& result : results)
      count(result);
    // The cases first: a task that comes late finds nothing to run.
    fs::remove(fs::path(path).replace_extension(".case"));
    fs::remove(path);
  }

  void count(const CaseResult& result)
  {
    ++(result.error.empty() ? progress_.done : progress_.failed);
    ++progress_.finished_here;
    progress_.running -= std::min<std::uint64_t>(progress_.running, 1);
    if (result.summary.contains("quality") && result.summary["quality"].is_number())
      progress_.best_quality =
          std::max(progress_.best_quality.value_or(0.0), result.summary["quality"].get<double>());
  }

  Engine& engine_;
  const SweepRunOptions& options_;
  std::string directory_;
  std::vector<std::string> keys_;
  CaseBuilder builder_;
  ResultStore& store_;
  const SweepPlan& plan_;
  CaseClaims claims_;
  SweepProgress progress_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

SweepOutcome runSweepOn(Engine& engine, const Sweep& sweep, const std::string& results,
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
