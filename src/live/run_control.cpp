#include "ratchet_sieve/live/run_control.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/recording/run_warnings.h"
#include "ratchet_sieve/scene/scene_text.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{
CommandFrame plainCommand(CommandKind kind)
{
  CommandFrame command;
  command.kind = kind;
  return command;
}

/// Times that differ by less than the nanosecond of a stamp are equal [s]: sums of durations round.
constexpr double RESOLUTION = 1e-9;

/// A paused run counts as under way during the lifetime of this.
class UnderWay
{
public:
  explicit UnderWay(Run& run) : run_(run) { run_.setUnderWay(true); }
  ~UnderWay() { run_.setUnderWay(false); }
  UnderWay(const UnderWay&) = delete;
  UnderWay& operator=(const UnderWay&) = delete;

private:
  Run& run_;
};

/// What a drive was asked and, where that is another value, what it gives the base.
CommandFrame driveCommand(const Drives& drives, Quantity quantity)
{
  CommandFrame command = setpointCommand(quantity, drives.asked(quantity));
  if (drives.output(quantity) != drives.asked(quantity))
    command.values.push_back(drives.output(quantity));
  return command;
}

/// A failure where the name is none of those known.
Outcome oneOf(const char* what, const std::string& name, const std::vector<std::string>& known)
{
  if (std::find(known.begin(), known.end(), name) != known.end())
    return {};
  return {false, fmt::format("{} {}: must be one of {}", what, shownText(name), fmt::join(known, ", "))};
}

/// The scene with its base as it moves now.
SceneDefinition withBase(SceneDefinition scene, const DriveState& base)
{
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    scene.base.*q.definition = base.*q.applied;
  scene.base.phase = base.phase;
  return scene;
}
}  // namespace

RunControl::RunControl(const YAML::Node& scene, const std::string& source, const RunParameters& parameters,
                       RunRecording& recording, RunLog log, PourObserver pour_observer)
    : scene_(scene),
      source_(source),
      parameters_(parameters),
      recording_(recording),
      log_(std::move(log)),
      pour_observer_(std::move(pour_observer)),
      paused_(parameters.start_paused)
{
  const Scene read = readScene(0, {});
  scene_warnings_ = read.warnings;
  announce(read);
  drives_.emplace(parameters_.drives, read.definition.base, 0.0);
  run_ = makeRun(read.definition, 0.0, read.definition.duration);
  sensors_ = makeSensors(parameters_.sensors, read.definition, 0.0);
  run_->setUnderWay(!paused_);
}

/// Logs the plan, the size and the implausible values of a scene before it is poured, which may take long.
void RunControl::announce(const Scene& scene) const
{
  log_.inform("plan: " + planText(planOf(scene.definition)));
  log_.inform(sizeText(scene.definition));
  for (const std::string& warning : scene.warnings)
    log_.warn(source_ + ": " + warning);
}

std::unique_ptr<Run> RunControl::makeRun(const SceneDefinition& scene, double start_time, double end_time)
{
  Simulation simulation(scene, start_time, pour_observer_);
  simulation.setThreads(parameters_.threads);
  simulation.keepExits(parameters_.window);
  auto run = std::make_unique<Run>(std::move(simulation), end_time);
  for (FrameSink* sink : sinks_)
    run->add(*sink, parameters_.rates);
  run->observeExits(
      [this](const ExitRecord& exit)
      {
        for (Sensor& sensor : sensors_)
          sensor.take(exit);
        if (exit_observer_)
          exit_observer_(exit);
      });
  return run;
}

void RunControl::addSink(FrameSink& sink)
{
  sinks_.push_back(&sink);
  run_->add(sink, parameters_.rates);
}

Scene RunControl::readScene(std::uint64_t seed, const std::vector<std::string>& overrides) const
{
  YAML::Node root = copyWithoutLines(scene_);
  for (const std::string& assignment : overrides)
    applyOverride(root, assignment);
  if (seed != 0)
    root["seed"] = seed;
  return sceneFromYaml(root, source_);
}

std::string RunControl::turnWarning() const
{
  return fastTurnText(run_->simulation().scene(), parameters_.slew_rates.inclination);
}

void RunControl::begin()
{
  if (const std::string warning = turnWarning(); !warning.empty())
    log_.warn(warning);
  if (recording_.on())
    run_->add(recording_, recording_.rates());
  std::vector<CommandFrame> opening = driveCommands();
  opening.insert(opening.begin(), slewRateCommand(parameters_.slew_rates));
  run_->open(std::move(opening));
  run_->takeDue();
  readDue(sensors_, run_->simulation(), sensor_observer_);
}

void RunControl::end()
{
  run_->takeAll();
  recording_.close();
}

void RunControl::pause()
{
  if (!paused_)
    run_->applyCommand(plainCommand(CommandKind::PAUSE));
  paused_ = true;
  run_->takeAll();
  run_->setUnderWay(false);
}

void RunControl::unpause()
{
  if (paused_)
    run_->applyCommand(plainCommand(CommandKind::UNPAUSE));
  paused_ = false;
  run_->setUnderWay(true);
}

std::optional<std::string> RunControl::whyNoStep(double duration) const
{
  if (!paused_)
    return "the simulation is not paused: pause it first";
  if (!std::isfinite(duration) || duration <= 0.0)
    return "duration " + std::to_string(duration) + " s: must be > 0 and finite";
  if (run_->finished())
    return run_->stopReason().value_or("the scene's end is reached: reset first");
  return std::nullopt;
}

Outcome RunControl::step(double duration, const Stride& stride)
{
  if (const auto reason = whyNoStep(duration))
    return {false, *reason};
  return advance(duration, stride);
}

Outcome RunControl::lockStep(const std::vector<std::pair<std::string, double>>& setpoints, double duration,
                             const Stride& stride)
{
  if (const auto reason = whyNoStep(duration))
    return {false, *reason};
  std::vector<Quantity> found;
  for (const auto& [name, value] : setpoints)
  {
    const auto setpoint =
        std::find_if(parameters_.setpoints.begin(), parameters_.setpoints.end(),
                     [&name = name](const Setpoint& known) { return known.name() == name; });
    if (setpoint == parameters_.setpoints.end())
      return {false, "setpoint " + shownText(name) + ": must be inclination, frequency or amplitude"};
    if (const auto refusal = setpoint->refusal(value))
      return {false, *refusal};
    found.push_back(setpoint->quantity);
  }
  // The response contains statistics.
  run_->keepStatistics();
  // A setpoint that changes nothing is not applied, because it would require new predictions for all disks.
  for (std::size_t k = 0; k < found.size(); ++k)
    if (commanded(found[k]) != setpoints[k].second)
      command(found[k], setpoints[k].second);
  return advance(duration, stride);
}

Outcome RunControl::advance(double duration, const Stride& stride)
{
  const UnderWay under_way(*run_);
  const double target = run_->time() + duration;
  bool aborted = false;
  while (run_->time() < target && !run_->finished() && !aborted)
    aborted = !stride(target);
  run_->takeAll();
  if (run_->stopped())
    return {false, *run_->stopReason()};
  if (target - run_->time() < RESOLUTION)
    return {};
  return {!aborted, fmt::format("{} at {:.9g} s: {:.9g} s of the step are left",
                                aborted ? "interrupted" : "the end of the run was reached", run_->time(),
                                target - run_->time())};
}

void RunControl::advanceTo(double time)
{
  run_->advanceTo(std::min({time, drives_->nextTime(), nextTime(sensors_)}));
  if (run_->time() >= drives_->nextTime())
  {
    drives_->advanceTo(run_->time());
    followDrives();
  }
  readDue(sensors_, run_->simulation(), sensor_observer_);
}

/// Of each drive that gives the base another value than before.
std::vector<CommandFrame> RunControl::driveCommands() const
{
  std::vector<CommandFrame> commands;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    if (drives_->output(q.quantity) != run_->simulation().base().*q.commanded)
      commands.push_back(driveCommand(*drives_, q.quantity));
  return commands;
}

void RunControl::followDrives()
{
  for (const CommandFrame& command : driveCommands())
    run_->applyCommand(command);
}

void RunControl::begin(std::unique_ptr<Run> run, const Drives& drives)
{
  run_->takeAll();
  recording_.openNext();
  run_ = std::move(run);
  drives_ = drives;
  sensors_ = makeSensors(parameters_.sensors, run_->simulation().scene(), run_->time());
  run_->setUnderWay(!paused_);
  begin();
}

Outcome RunControl::reset(std::uint64_t seed, const std::vector<std::string>& overrides, bool keep_time)
{
  try
  {
    const Scene scene = readScene(seed, overrides);
    const double start = keep_time ? run_->time() : 0.0;
    announce(scene);
    begin(makeRun(scene.definition, start, start + scene.definition.duration),
          Drives(parameters_.drives, scene.definition.base, start));
    scene_warnings_ = scene.warnings;
    return {};
  }
  catch (const SceneError& error)
  {
    return {false, error.what()};
  }
  catch (const std::invalid_argument& error)
  {
    return {false, source_ + ": " + error.what()};
  }
}

Outcome RunControl::resetWorld()
{
  try
  {
    const SceneDefinition scene = withBase(run_->simulation().scene(), run_->simulation().base());
    // Disks poured at the end of a run get the same duration as the first.
    const bool at_end = run_->time() >= run_->endTime();
    const double end = at_end ? run_->time() + scene.duration : run_->endTime();
    begin(makeRun(scene, run_->time(), end), *drives_);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return {false, error.what() + std::string(", with the base in its present position; the run continues")};
  }
}

Outcome RunControl::pour(const std::string& species, std::size_t count, const std::optional<Stretch>& between)
{
  if (count < 1 || count > MOST_POURED)
    return {false, "count " + std::to_string(count) + ": must be from 1 to " + std::to_string(MOST_POURED)};
  const auto& all = run_->simulation().scene().species;
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const SpeciesDefinition& candidate) { return candidate.name == species; });
  if (found == all.end())
    return {false, "species " + shownText(species) + ": there is none of that name"};
  try
  {
    CommandFrame command = plainCommand(CommandKind::POUR);
    command.species = static_cast<std::uint32_t>(found - all.begin());
    command.count = static_cast<std::uint32_t>(count);
    if (between)
      command.values = {between->from, between->to};
    run_->applyCommand(command);
  }
  catch (const std::invalid_argument& error)
  {
    return {false, error.what()};
  }
  run_->show(run_->now<ParticleFrame>());
  run_->show(run_->now<BinFrame>());
  return {};
}

void RunControl::command(Quantity quantity, double value)
{
  drives_->ask(quantity, value, run_->time());
  drives_->advanceTo(run_->time());
  run_->applyCommand(driveCommand(*drives_, quantity));
  followDrives();
  run_->show(run_->now<BaseFrame>());
}

Outcome RunControl::fault(const std::string& part, const std::string& fault)
{
  std::vector<std::string> parts, faults;
  const auto is_part = [&](const std::string& name) { return parts.emplace_back(name) == part; };
  std::function<void()> set;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    if (is_part(q.name))
    {
      faults = Drives::faults(q.quantity);
      set = [&] { drives_->setFault(q.quantity, fault, run_->simulation().base().*q.applied); };
    }
  for (Sensor& sensor : sensors_)
    if (is_part(sensor.info().name))
    {
      faults = sensor.faults();
      set = [&] { sensor.setFault(fault); };
    }
  if (Outcome known = oneOf("part", part, parts); !known.success)
    return known;
  if (Outcome known = oneOf("fault", fault, faults); !known.success)
    return known;
  set();
  followDrives();
  return {};
}

void RunControl::tare(const std::string& name)
{
  for (Sensor& sensor : sensors_)
    if (name == sensor.info().name)
      sensor.tare(run_->time());
}

}  // namespace ratchet_sieve
