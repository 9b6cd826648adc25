#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "command_line.h"
#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/checkpoint.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/scene_text.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/floor_check.h"
#include "run_arguments.h"
#include "run_outputs.h"

namespace
{

using namespace ratchet_sieve;

constexpr double MM_PER_M = 1e3;

void warn(const std::string& text)
{
  std::fprintf(stderr, "sieve_run: warning: %s\n", text.c_str());
}

/// @throws std::runtime_error if a signal stops the pour
Simulation makeSimulation(const SceneDefinition& scene, const std::string& path)
{
  ProgressBar bar;
  const auto observer = [&bar](std::size_t poured, std::size_t of)
  {
    if (stop_requested)
      throw std::runtime_error("stopped when " + std::to_string(poured) + " of " + countText(of, "disk") +
                               " were poured; nothing was written");
    bar.show(poured, of);
  };
  return orRefuse<std::invalid_argument>([&] { return Simulation(scene, 0.0, observer); }, path + ": ");
}

/// @throws OutputError
void requireReplaceable(const std::string& checkpoint)
{
  std::error_code ignored;
  if (std::filesystem::is_fifo(checkpoint, ignored))
    failToWrite(checkpoint, "it is a pipe; must be a file, which each checkpoint replaces");
  const AtomicFile probe(checkpoint);
}

/// Has a run saved periodically. A full disk does not end it, but causes a warning.
/// @param failure why the last checkpoint was not saved, or empty; outlives the run
void saveInto(const std::string& path, const Simulation& simulation, const RunProgress& progress,
              RunWatchers& watchers, std::string& failure)
{
  // The start is saved, so that a bad path is an error before any work is done.
  orRefuse<OutputError>([&] { writeCheckpoint(path, simulation, progress); });
  watchers.save = [&path, &failure](const Simulation& now, const RunProgress& so_far)
  {
    const std::string before = std::exchange(failure, "");
    try
    {
      writeCheckpoint(path, now, so_far);
    }
    catch (const OutputError& error)
    {
      failure = error.what();
      if (failure != before)
        warn(failure);
    }
  };
}

Checkpoint begin(const SceneDefinition& scene, const std::string& path)
{
  Simulation simulation = makeSimulation(scene, path);
  const RunProgress progress = firstProgress(simulation);
  return {progress, std::move(simulation)};
}

void announce(const Scene& scene, bool verbose)
{
  if (verbose)
    std::fprintf(stderr, "sieve_run: plan: %s\n", planText(planOf(scene.definition)).c_str());
  std::fprintf(stderr, "sieve_run: %s\n", sizeText(scene.definition).c_str());
  for (const std::string& warning : scene.warnings)
    warn(warning);
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
  const nlohmann::ordered_json runs = floorCheck(scene, summary, [] { return stop_requested.load(); });
  summary["floor_check"] = runs;
  if (runs.is_null())
    std::fputs("sieve_run: the check of contact.min_rebound_speed was stopped\n", stderr);
  else
    for (const std::string& line : floorCheckLines(runs))
      std::fprintf(stderr, "sieve_run: %s\n", line.c_str());
  return !runs.is_null();
}

/// "Q 0.78, P 0.99; A: 3 left, 130 right; B: ..."; the mean velocities where no disk can leave.
std::string resultText(const nlohmann::ordered_json& summary, Boundary boundary)
{
  const auto number = [](const nlohmann::ordered_json& value, const char* format, double scale = 1.0)
  { return value.is_null() ? "undefined" : fmt::format(format, scale * value.get<double>()); };
  const bool open = boundary == Boundary::OPEN || summary["processed"].is_number();
  std::string text =
      open ? "Q " + number(summary["quality"], "{:.2f}") + ", P " + number(summary["processed"], "{:.2f}")
           : "mean velocities";
  for (const auto& species : summary["species"])
    text += fmt::format("; {}: ", shownText(species["name"].get<std::string>())) +
            (open ? fmt::format("{} left, {} right", species["left"].dump(), species["right"].dump())
                  : number(species["mean_vx"], "{:+.1f}", MM_PER_M) + " ± " +
                        number(species["mean_vx_stderr"], "{:.1f}", MM_PER_M) + " mm/s");
  return text;
}

/// "; wrote run.json, run.html"; nothing where no file was written.
std::string writtenText(const RunArguments& arguments)
{
  std::string text;
  for (const std::string& path : {arguments.summary, arguments.page.path, arguments.bag, arguments.trajectory,
                                  arguments.collisions, arguments.exits, arguments.checkpoint})
    if (!path.empty())
      text += (text.empty() ? "; wrote " : ", ") + shownText(path);
  return text;
}

int run(const RunArguments& arguments)
{
  // CLI11 would give the PART of --keys to a required SCENE.
  if (arguments.scene.empty())
    throw Refusal("SCENE is required; see --help");
  const Scene scene =
      orRefuse<SceneError>([&] { return loadSceneFile(arguments.scene, arguments.overrides); });
  requireFloorToCheck(arguments, scene.definition);
  attendSignals();
  // All checks that can refuse the run come before its first output. The pour refuses nothing and may take
  // long, so it comes last.
  const bool pours = arguments.resume.empty() && scene.definition.initial.empty();
  std::optional<Checkpoint> start;
  if (!arguments.resume.empty())
    start = orRefuse<CheckpointError>([&] { return readCheckpoint(arguments.resume, scene.definition); });
  else if (!pours)
    start = begin(scene.definition, arguments.scene);
  RunOutputs outputs(arguments, scene.feed_file);
  if (!arguments.checkpoint.empty())  // before the pour, which may take long
    orRefuse<OutputError>([&] { requireReplaceable(arguments.checkpoint); });
  announce(scene, arguments.verbose);
  if (pours)
    start = begin(scene.definition, arguments.scene);
  auto& [so_far, simulation] = *start;
  simulation.setThreads(arguments.threads);
  RunWatchers watchers;
  std::string not_saved;
  if (!arguments.checkpoint.empty())
    saveInto(arguments.checkpoint, simulation, so_far, watchers, not_saved);
  outputs.watch(simulation, watchers);
  watchers.stop_wanted = [] { return stop_requested.load(); };
  watchers.save_period = arguments.checkpoint_every;
  RunOutcome outcome;
  {
    ProgressBar progress;
    watchers.progress = [&progress](const Simulation& now) { progress.show(now); };
    outcome = runToEnd(simulation, watchers, so_far);
  }
  for (const std::string& warning : outcome.warnings)
    warn(warning);
  outcome.warnings.insert(outcome.warnings.begin(), scene.warnings.begin(), scene.warnings.end());
  const bool through = outcome.end != RunEnd::STOPPED && outcome.end != RunEnd::STALLED;
  nlohmann::ordered_json summary = summarize(simulation, outcome);
  const bool checked = !arguments.check_floor || !through || checkFloor(scene.definition, summary);
  const bool complete = outputs.finish(summary);
  if (complete)
    std::fprintf(stderr, "sieve_run: %s%s\n", resultText(summary, scene.definition.boundary).c_str(),
                 writtenText(arguments).c_str());
  return through && not_saved.empty() && checked && complete ? DONE : FAILED;
}

int runWithinMemory(const RunArguments& arguments)
{
  try
  {
    return run(arguments);
  }
  catch (const std::bad_alloc& error)
  {
    throw std::runtime_error(arguments.scene + ": " + errorText(error));
  }
}

}  // namespace

int main(int argc, char** argv)
{
  RunArguments arguments;
  CLI::App app("Run a scene of the ratchet sieve as fast as possible and print a summary as JSON.",
               "sieve_run");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return runWithinMemory(arguments); });
}
