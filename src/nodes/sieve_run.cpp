#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint_saver.h"
#include "command_line.h"
#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/floor_check.h"
#include "run_arguments.h"
#include "run_outputs.h"

namespace
{

using namespace ratchet_sieve;

volatile std::sig_atomic_t stop_signal = 0;

void onSignal(int signal)
{
  stop_signal = signal;
}

Scene loadScene(const RunArguments& arguments)
{
  try
  {
    return loadSceneFile(arguments.scene, arguments.allOverrides());
  }
  catch (const SceneError& error)
  {
    throw Refusal(error.what());
  }
}

/// @throws std::runtime_error if a signal stops the pour
Simulation makeSimulation(const SceneDefinition& scene, const std::string& path)
{
  ProgressBar bar;
  const auto observer = [&bar](std::size_t poured, std::size_t of)
  {
    if (stop_signal != 0)
      throw std::runtime_error("stopped when " + std::to_string(poured) + " of " + countText(of, "disk") +
                               " were poured; nothing was written");
    bar.show(poured, of);
  };
  try
  {
    return Simulation(scene, 0.0, observer);
  }
  catch (const std::invalid_argument& error)
  {
    throw Refusal(path + ": " + error.what());
  }
}

Checkpoint resume(const SceneDefinition& scene, const std::string& path)
{
  try
  {
    return readCheckpoint(path, scene);
  }
  catch (const CheckpointError& error)
  {
    throw Refusal(error.what());
  }
}

/// Called before the pour, which may take long.
void requireWritable(const std::string& path)
{
  try
  {
    if (!path.empty())
      AtomicFile probe(path);
  }
  catch (const OutputError& error)
  {
    throw Refusal(error.what());
  }
}

std::unique_ptr<CheckpointSaver> makeSaver(const RunArguments& arguments, const Simulation& simulation,
                                           const RunProgress& progress)
{
  if (arguments.checkpoint.empty())
    return nullptr;
  try
  {
    return std::make_unique<CheckpointSaver>(arguments.checkpoint, simulation, progress);
  }
  catch (const OutputError& error)
  {
    throw Refusal(error.what());
  }
}

Checkpoint begin(const SceneDefinition& scene, const std::string& path)
{
  Simulation simulation = makeSimulation(scene, path);
  const RunProgress progress = firstProgress(simulation);
  return {progress, std::move(simulation)};
}

void announce(const Scene& scene)
{
  std::fprintf(stderr, "sieve_run: plan: %s\n", planText(planOf(scene.definition)).c_str());
  std::fprintf(stderr, "sieve_run: %s\n", sizeText(scene.definition).c_str());
  for (const std::string& warning : scene.warnings)
    std::fprintf(stderr, "sieve_run: warning: %s\n", warning.c_str());
}

void requireFloorToCheck(const RunArguments& arguments, const SceneDefinition& scene)
{
  if (arguments.check_floor && scene.contact.min_rebound_speed <= 0.0)
    throw Refusal("--check-floor: contact.min_rebound_speed of " + arguments.scene +
                  " is 0: there is no floor to check");
}

/// @return false if it was stopped
bool checkFloor(const SceneDefinition& scene, nlohmann::ordered_json& summary)
{
  const nlohmann::ordered_json runs = floorCheck(scene, summary, [] { return stop_signal != 0; });
  summary["floor_check"] = runs;
  if (runs.is_null())
    std::fputs("sieve_run: the check of contact.min_rebound_speed was stopped\n", stderr);
  else
    for (const std::string& line : floorCheckLines(runs))
      std::fprintf(stderr, "sieve_run: %s\n", line.c_str());
  return !runs.is_null();
}

int run(const RunArguments& arguments)
{
  // CLI11 would give the PART of --keys to a required SCENE.
  if (arguments.scene.empty())
    throw Refusal("SCENE is required; see --help");
  const Scene scene = loadScene(arguments);
  requireFloorToCheck(arguments, scene.definition);
  attendSignals(onSignal);
  // All checks that can refuse the run come before its first output. The pour refuses nothing and may take
  // long, so it comes last.
  const bool pours = arguments.resume.empty() && scene.definition.initial.empty();
  std::optional<Checkpoint> start;
  if (!pours)
    start = arguments.resume.empty() ? begin(scene.definition, arguments.scene)
                                     : resume(scene.definition, arguments.resume);
  RunOutputs outputs(arguments, scene.feed_file);
  requireWritable(arguments.checkpoint);
  announce(scene);
  if (pours)
    start = begin(scene.definition, arguments.scene);
  auto& [so_far, simulation] = *start;
  simulation.setThreads(arguments.threads);
  const std::unique_ptr<CheckpointSaver> saver = makeSaver(arguments, simulation, so_far);
  RunWatchers watchers;
  outputs.watch(simulation, watchers);
  watchers.stop_wanted = [] { return stop_signal != 0; };
  if (saver)
    watchers.save = [&saver](const Simulation& now, const RunProgress& progress)
    { saver->save(now, progress); };
  watchers.save_period = arguments.checkpoint_every;
  RunOutcome outcome;
  {
    ProgressBar progress;
    watchers.progress = [&progress](const Simulation& now) { progress.show(now); };
    outcome = runToEnd(simulation, watchers, so_far);
  }
  for (const std::string& warning : outcome.warnings)
    std::fprintf(stderr, "sieve_run: warning: %s\n", warning.c_str());
  outcome.warnings.insert(outcome.warnings.begin(), scene.warnings.begin(), scene.warnings.end());
  const bool all_saved = !saver || saver->saved();
  const bool through = outcome.end != RunEnd::STOPPED && outcome.end != RunEnd::STALLED;
  nlohmann::ordered_json summary = summarize(simulation, outcome);
  const bool checked = !arguments.check_floor || !through || checkFloor(scene.definition, summary);
  const bool complete = outputs.finish(summary, outcome.warnings);
  return through && all_saved && checked && complete ? DONE : FAILED;
}

}  // namespace

int main(int argc, char** argv)
{
  RunArguments arguments;
  CLI::App app("Run a scene of the ratchet sieve as fast as possible and print a summary as JSON.",
               "sieve_run");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return run(arguments); });
}
