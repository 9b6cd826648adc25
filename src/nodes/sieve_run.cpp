#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bag_output.h"
#include "checkpoint_saver.h"
#include "command_line.h"
#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/collision_file.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace
{

using namespace ratchet_sieve;

volatile std::sig_atomic_t stop_signal = 0;

void onSignal(int signal)
{
  stop_signal = signal;
}

struct Arguments
{
  std::string scene;
  std::vector<std::string> overrides;
  std::string seed;
  std::string duration;
  std::vector<std::string> until;
  std::string bag;
  std::string collisions;
  std::string summary;
  std::string checkpoint;
  double checkpoint_every = 60.0;
  std::string resume;
  std::size_t threads = 1;

  /// --seed, --duration and --until are overrides too: the scene's own rules check them.
  std::vector<std::string> allOverrides() const
  {
    std::vector<std::string> all = overrides;
    if (!seed.empty())
      all.push_back("seed=" + seed);
    if (!duration.empty())
      all.push_back("duration=" + duration);
    for (const std::string& assignment : until)
      all.push_back("accuracy." + assignment);
    return all;
  }
};

/// The error in an option's time; empty if it is valid. CLI11's own validator names the
/// largest of all doubles, in full.
std::string requireSeconds(const std::string& text)
{
  return std::strtod(text.c_str(), nullptr) >= 0.0 ? "" : text + ": must be 0 s or more";
}

/// The error in what --until is to set: accuracy has keys that do not decide when a run ends.
std::string requireCertaintyKey(const std::string& assignment)
{
  const std::string key = assignment.substr(0, assignment.find('='));
  std::string known;
  for (const std::string& name : certaintyKeyNames())
  {
    if (key == name)
      return "";
    known += (known.empty() ? "" : ", ") + name;
  }
  return key + ": unknown key; known are " + known;
}

void describe(CLI::App& app, Arguments& arguments)
{
  app.add_option("SCENE", arguments.scene, "The scene, a YAML file")->required()->type_name("FILE");
  app.add_option("--set", arguments.overrides,
                 "Set a key of the scene, such as base.inclination=0.105 or "
                 "species.0.radius=0.004; may be given again")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--seed", arguments.seed, "Seed, instead of the scene's")->type_name("N");
  app.add_option("--duration", arguments.duration, "Simulated time [s], instead of the scene's")
      ->type_name("S");
  app.add_option(
         "--until", arguments.until,
         "Set accuracy.KEY: end before the duration, once mean_vx [m/s] or quality, or both, are known "
         "within so much, with a confidence (0.95); may be given again")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->check(requireCertaintyKey);
  app.add_option("--bag", arguments.bag, "Record the run into a ROS bag")->type_name("FILE");
  app.add_option("--collisions", arguments.collisions, "Write every collision as CSV")->type_name("FILE");
  app.add_option("--summary", arguments.summary, "Write the summary there, not to standard output")
      ->type_name("FILE");
  app.add_option("--checkpoint", arguments.checkpoint,
                 "Save the run there at its end, when it is stopped, and now and then")
      ->type_name("FILE");
  app.add_option("--checkpoint-every", arguments.checkpoint_every,
                 "Save it so often, in seconds of wall time")
      ->type_name("S")
      ->check(requireSeconds)
      ->capture_default_str();
  app.add_option("--resume", arguments.resume,
                 "Go on, bit for bit, from there to the scene's end; of the scene only duration and what "
                 "--until sets may differ")
      ->type_name("FILE");
  app.add_option(
         "--threads", arguments.threads,
         "Run on so many threads, 0: as many as there are processors; used by disks that do not see each "
         "other, and for the same results")
      ->type_name("N")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  app.footer("Exit status: 0 done; 2 bad arguments or bad scene, nothing written; 1 anything else.");
}

/// What the run writes, each opened before it starts.
class Outputs
{
public:
  explicit Outputs(const Arguments& arguments)
  {
    try
    {
      if (!arguments.summary.empty())
        summary_ = std::make_unique<AtomicFile>(arguments.summary);
      if (!arguments.collisions.empty())
        collisions_ = std::make_unique<CollisionFile>(arguments.collisions);
      if (!arguments.bag.empty())
        bag_ = std::make_unique<BagOutput>(arguments.bag);
    }
    catch (const std::exception& error)
    {
      throw Refusal(error.what());
    }
  }

  void watch(Simulation& simulation, RunWatchers& watchers)
  {
    if (collisions_)
      simulation.observeCollisions([this](const CollisionRecord& record) { collisions_->take(record); });
    if (bag_)
      watchers.frames = &bag_->sink();
  }

  void finish(const nlohmann::ordered_json& summary)
  {
    if (bag_)
      bag_->close();
    if (collisions_)
      collisions_->commit();
    const std::string text = summary.dump(2) + "\n";
    if (summary_)
    {
      summary_->stream() << text;
      summary_->commit();
    }
    else if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
      throw std::runtime_error("the summary could not be written to standard output");
  }

private:
  std::unique_ptr<AtomicFile> summary_;
  std::unique_ptr<CollisionFile> collisions_;
  std::unique_ptr<BagOutput> bag_;
};

Scene loadScene(const Arguments& arguments)
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

/// @throws std::runtime_error where a signal stops the pour
Simulation makeSimulation(const SceneDefinition& scene, const std::string& path)
{
  PourBar bar;
  const auto observer = [&bar](std::size_t poured, std::size_t of)
  {
    if (stop_signal != 0)
      throw std::runtime_error("stopped when " + std::to_string(poured) + " of " + std::to_string(of) +
                               " disks were poured; nothing was written");
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

/// Before a pour, which may take long.
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

std::unique_ptr<CheckpointSaver> makeSaver(const Arguments& arguments, const Simulation& simulation,
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

int run(const Arguments& arguments)
{
  const Scene scene = loadScene(arguments);
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  // All checks that can refuse the run precede its first output. The pour refuses nothing and may take long,
  // so it is last.
  const bool pours = arguments.resume.empty() && scene.definition.initial.empty();
  std::optional<Checkpoint> start;
  if (!pours)
    start = arguments.resume.empty() ? begin(scene.definition, arguments.scene)
                                     : resume(scene.definition, arguments.resume);
  Outputs outputs(arguments);
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
    ProgressBar progress(simulation);
    watchers.progress = [&progress](const Simulation& now) { progress.show(now); };
    outcome = runToEnd(simulation, watchers, so_far);
  }
  for (const std::string& warning : outcome.warnings)
    std::fprintf(stderr, "sieve_run: warning: %s\n", warning.c_str());
  outcome.warnings.insert(outcome.warnings.begin(), scene.warnings.begin(), scene.warnings.end());
  outputs.finish(summarize(simulation, outcome));
  const bool all_saved = !saver || saver->saved();
  const bool through = outcome.end == RunEnd::COMPLETED || outcome.end == RunEnd::ACCURATE;
  return through && all_saved ? DONE : FAILED;
}

}  // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  CLI::App app("Runs a scene of the ratchet sieve as fast as it goes and sums it up in JSON.", "sieve_run");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return run(arguments); });
}
