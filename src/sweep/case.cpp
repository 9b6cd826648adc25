#include "ratchet_sieve/sweep/case.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <sstream>

#include <unistd.h>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/checkpoint.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::size_t LONGEST_SHOWN_CASE = 200;  ///< [characters]

/// The value at a dotted path, as text, if the tree has one.
std::optional<std::string> valueAt(const YAML::Node& tree, const std::string& path)
{
  YAML::Node node;
  node.reset(tree);
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');)
  {
    const YAML::Node& parent = node;
    if (parent.IsScalar() || !parent.IsDefined())
      return std::nullopt;
    // An element of a list is named by its index; applyOverride() or the scene reader has refused other
    // names.
    const YAML::Node child = parent.IsSequence() ? parent[std::stoul(part)] : parent[part];
    if (!child.IsDefined() || child.IsNull())
      return std::nullopt;
    node.reset(child);
  }
  return flowText(node);
}

class CaseRun
{
public:
  CaseRun(const SweepCase& sweep_case, const CaseRunOptions& options) : case_(sweep_case), options_(options)
  {
  }

  /// @return the summary, or nothing if stopped before the run began
  std::optional<nlohmann::ordered_json> run(std::string& error, bool& stopped)
  {
    std::optional<Checkpoint> start = begin();
    if (!start)
      return std::nullopt;
    RunWatchers watchers;
    watchers.stop_wanted = options_.stop_wanted;
    watchers.save_period = options_.checkpoint_period;
    if (!options_.checkpoint.empty())
      watchers.save = [this](const Simulation& now, const RunProgress& progress)
      {
        if (now.time() < now.scene().duration)  // a completed run needs none
          write([&] { writeCheckpoint(options_.checkpoint, now, progress); });
      };
    CaseRecord record;
    if (options_.record)
    {
      record = options_.record(case_);
      watchers.frames.push_back({record.sink.get(), record.rates});
    }
    RunOutcome outcome = runToEnd(start->simulation, watchers, start->progress);
    stopped = outcome.end == RunEnd::STOPPED;
    if (outcome.end == RunEnd::STALLED)
      error = outcome.warnings.empty() ? "inelastic collapse" : outcome.warnings.front();
    outcome.warnings.insert(outcome.warnings.begin(), case_.warnings.begin(), case_.warnings.end());
    nlohmann::ordered_json summary = summarize(start->simulation, outcome);
    if (record.keep && !stopped)
      write([&] { record.keep(summary); });
    return summary;
  }

private:
  std::optional<Checkpoint> begin() const
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
    std::optional<Simulation> simulation = poured(case_.scene, options_.stop_wanted);
    if (!simulation)
      return std::nullopt;
    const RunProgress progress = firstProgress(*simulation);
    return Checkpoint{progress, std::move(*simulation)};
  }

  /// Warns if an output cannot be written.
  void write(const std::function<void()>& output) const
  {
    try
    {
      output();
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

CaseBuilder::CaseBuilder(const Sweep& sweep)
    : sweep_(sweep), keys_(sweep.keys()), base_(copyableYaml(sweep.scene_text, sweep.scene_source))
{
}

const SweepCase& CaseBuilder::at(std::uint64_t position)
{
  const std::uint64_t point = position / sweep_.seedCount();
  if (point_ != point)
  {
    point_.reset();
    try
    {
      build(point);
    }
    catch (const SceneError& error)
    {
      throw SceneError(sweep_.source + ": case " + std::to_string(position + 1) + " (" +
                       shownText(name(position), LONGEST_SHOWN_CASE) + "): " + error.what());
    }
    point_ = point;
  }
  case_.position = position;
  case_.scene.seed = sweep_.seeds.count > 0 ? sweep_.seeds.at(position % sweep_.seeds.count) : own_seed_;
  return case_;
}

void CaseBuilder::build(std::uint64_t point)
{
  YAML::Node tree = copyWithoutLines(base_);
  for (const Assignment& assignment : sweep_.fixed)
    applyOverride(tree, assignment.key + '=' + assignment.value);
  const std::vector<Assignment> swept = sweep_.point(point);
  for (const Assignment& assignment : swept)
    applyOverride(tree, assignment.key + '=' + assignment.value);
  for (const Assignment& assignment : swept)
    if (!valueAt(tree, assignment.key))
      throw SceneError(assignment.key + ": another swept key takes it out; sweep one of the two");
  Scene scene = sceneFromYaml(tree, sweep_.scene_source);
  case_.scene = std::move(scene.definition);
  case_.warnings = std::move(scene.warnings);
  own_seed_ = case_.scene.seed;
  case_.values.clear();
  for (const std::string& key : keys_)
    case_.values.emplace_back(key, valueAt(tree, key));
}

std::string CaseBuilder::name(std::uint64_t position) const
{
  std::string setting = settingName(position / sweep_.seedCount());
  if (sweep_.seeds.count == 0)
    return setting;
  const std::string seed = "seed=" + std::to_string(sweep_.seeds.at(position % sweep_.seeds.count));
  return keys_.empty() ? seed : setting + ' ' + seed;
}

std::string CaseBuilder::settingName(std::uint64_t point) const
{
  std::string text;
  for (const Assignment& assignment : sweep_.point(point))
    text += (text.empty() ? "" : " ") + assignment.key + '=' + assignment.value;
  return text.empty() ? "the scene itself" : text;
}

std::optional<Simulation> poured(const SceneDefinition& scene, const std::function<bool()>& stop_wanted)
{
  struct Stopped
  {
  };
  const auto look = [&stop_wanted](std::size_t, std::size_t)
  {
    if (stop_wanted && stop_wanted())
      throw Stopped();
  };
  try
  {
    return Simulation(scene, 0.0, look);
  }
  catch (const Stopped&)
  {
    return std::nullopt;
  }
}

CaseResult resultFor(const SweepCase& sweep_case)
{
  CaseResult result;
  result.run_hash = runHash(sweep_case.scene);
  result.scene_hash = sceneHash(sweep_case.scene);
  result.seed = sweep_case.scene.seed;
  result.values = sweep_case.values;
  char host[256] = "";
  result.host = gethostname(host, sizeof host - 1) == 0 ? host : "unknown";
  return result;
}

std::optional<CaseResult> runCase(const SweepCase& sweep_case, const CaseRunOptions& options)
{
  const auto start = std::chrono::steady_clock::now();
  CaseResult result = resultFor(sweep_case);
  bool stopped = false;
  try
  {
    std::optional<nlohmann::ordered_json> summary = CaseRun(sweep_case, options).run(result.error, stopped);
    if (!summary)
      return std::nullopt;
    result.summary = std::move(*summary);
  }
  catch (const std::exception& error)
  {
    result.error = errorText(error);
  }
  result.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!stopped)
    return result;
  if (options.take_stopped)
    options.take_stopped(result);
  return std::nullopt;
}

}  // namespace ratchet_sieve
