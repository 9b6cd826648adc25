#include "ratchet_sieve/sweep/case_run.h"

#include <chrono>
#include <exception>
#include <filesystem>

#include <unistd.h>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/checkpoint.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/canonical_scene.h"

namespace ratchet_sieve
{
namespace
{

/// Thrown to cancel a pour.
struct PourStopped
{
};

class CaseRun
{
public:
  CaseRun(const SweepCase& sweep_case, const CaseRunOptions& options) : case_(sweep_case), options_(options)
  {
  }

  /// @return the summary, or nothing if stopped
  std::optional<nlohmann::ordered_json> run(std::string& error)
  {
    Checkpoint start = begin();
    RunWatchers watchers;
    watchers.stop_wanted = options_.stop_wanted;
    watchers.save_period = options_.checkpoint_period;
    if (!options_.checkpoint.empty())
      watchers.save = [this](const Simulation& now, const RunProgress& progress) { save(now, progress); };
    CaseRecord record;
    if (options_.record)
    {
      record = options_.record(case_);
      watchers.frames.push_back({record.sink.get(), record.rates});
    }
    RunOutcome outcome = runToEnd(start.simulation, watchers, start.progress);
    if (outcome.end == RunEnd::STOPPED)
      return std::nullopt;
    if (outcome.end == RunEnd::STALLED)
      error = outcome.warnings.empty() ? "inelastic collapse" : outcome.warnings.front();
    outcome.warnings.insert(outcome.warnings.begin(), case_.warnings.begin(), case_.warnings.end());
    keep(record, outcome.warnings);
    return summarize(start.simulation, outcome);
  }

private:
  Checkpoint begin() const
  {
    if (!options_.checkpoint.empty() && std::filesystem::exists(options_.checkpoint))
    {
      try
      {
        return readCheckpoint(options_.checkpoint, case_.scene);
      }
      catch (const CheckpointError& error)
      {
        warn(std::string(error.what()) + "; the case restarts");
      }
    }
    Simulation simulation(case_.scene, 0.0,
                          [this](std::size_t, std::size_t)
                          {
                            if (options_.stop_wanted && options_.stop_wanted())
                              throw PourStopped();
                          });
    const RunProgress progress = firstProgress(simulation);
    return {progress, std::move(simulation)};
  }

  /// A completed run needs no checkpoint.
  void save(const Simulation& simulation, const RunProgress& progress) const
  {
    if (simulation.time() >= simulation.scene().duration)
      return;
    try
    {
      writeCheckpoint(options_.checkpoint, simulation, progress);
    }
    catch (const OutputError& error)
    {
      warn(error.what());
    }
  }

  void keep(const CaseRecord& record, const std::vector<std::string>& warnings) const
  {
    if (!record.keep)
      return;
    try
    {
      record.keep(warnings);
    }
    catch (const OutputError& error)
    {
      warn(error.what());
    }
  }

  void warn(const std::string& text) const
  {
    if (options_.warn)
      options_.warn(text);
  }

  const SweepCase& case_;
  const CaseRunOptions& options_;
};

}  // namespace

CaseResult resultFor(const SweepCase& sweep_case)
{
  CaseResult result;
  result.run_hash = runHash(sweep_case.scene);
  result.scene_hash = sceneHash(sweep_case.scene);
  result.seed = sweep_case.scene.seed;
  result.values = sweep_case.values;
  result.host = hostName();
  return result;
}

std::optional<CaseResult> runCase(const SweepCase& sweep_case, const CaseRunOptions& options)
{
  const auto start = std::chrono::steady_clock::now();
  CaseResult result = resultFor(sweep_case);
  try
  {
    std::optional<nlohmann::ordered_json> summary = CaseRun(sweep_case, options).run(result.error);
    if (!summary)
      return std::nullopt;
    result.summary = std::move(*summary);
  }
  catch (const PourStopped&)
  {
    return std::nullopt;
  }
  catch (const std::exception& error)
  {
    result.error = error.what();
  }
  result.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::string hostName()
{
  char name[256] = "";
  if (gethostname(name, sizeof name - 1) != 0)
    return "unknown";
  return name;
}

}  // namespace ratchet_sieve
