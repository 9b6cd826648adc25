#include "ratchet_sieve/ros/run_control.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <ros/console.h>

namespace ratchet_sieve
{
namespace
{
/// More at once is a slip, and would take the machine's memory.
constexpr std::size_t MOST_POURED = 1000000;

Outcome failure(const std::string& message)
{
  return {false, message};
}

void apply(SetpointKind kind, double value, Simulation& simulation)
{
  switch (kind)
  {
    case SetpointKind::INCLINATION:
      return simulation.commandInclination(value);
    case SetpointKind::FREQUENCY:
      return simulation.commandFrequency(value);
    case SetpointKind::AMPLITUDE:
      return simulation.commandAmplitude(value);
  }
}

/// The scene with its base as it moves now.
SceneDefinition withBase(SceneDefinition scene, const DriveState& base)
{
  scene.base.inclination = base.inclination;
  scene.base.frequency = base.frequency;
  scene.base.amplitude = base.amplitude;
  scene.base.phase = base.phase;
  return scene;
}
}  // namespace

RunControl::RunControl(const YAML::Node& scene, const std::string& source, const NodeParameters& parameters,
                       Recorder& recorder)
    : scene_(YAML::Clone(scene)),
      source_(source),
      parameters_(parameters),
      recorder_(recorder),
      paused_(parameters.start_paused)
{
  const Scene read = readScene(0, {});
  scene_warnings_ = read.warnings;
  run_ = std::make_unique<LiveRun>(read.definition, parameters_.rates, parameters_.slew_rates, 0.0,
                                   read.definition.duration);
}

Scene RunControl::readScene(std::uint64_t seed, const std::vector<std::string>& overrides) const
{
  YAML::Node root = YAML::Clone(scene_);
  for (const std::string& assignment : overrides)
    applyOverride(root, assignment);
  if (seed != 0)
    root["seed"] = seed;
  return sceneFromYaml(root, source_);
}

void RunControl::begin()
{
  ROS_INFO_STREAM("plan: " << planText(run_->simulation().plan()));
  if (recorder_.on())
    run_->record(recorder_, recorder_.rates());
  run_->takeDue(sinks_);
}

void RunControl::end()
{
  run_->takeAll(sinks_);
  recorder_.close();
}

void RunControl::pause()
{
  paused_ = true;
  run_->takeAll(sinks_);
}

Outcome RunControl::step(double duration, double stride, const std::function<bool()>& keep_going)
{
  if (!paused_)
    return failure("the simulation is not paused: pause it first");
  if (!std::isfinite(duration) || duration <= 0.0)
    return failure("duration " + std::to_string(duration) + " s: must be > 0 and finite");
  if (run_->finished())
    return failure(run_->stopReason().value_or("the scene's end is reached: reset first"));
  const double target = run_->elapsed() + duration;
  while (run_->elapsed() < target && !run_->finished())
  {
    if (!keep_going())
      return failure("interrupted");
    advanceTo(std::min(target, run_->elapsed() + stride));
  }
  run_->takeAll(sinks_);
  return run_->stopped() ? failure(*run_->stopReason()) : Outcome{};
}

void RunControl::begin(std::unique_ptr<LiveRun> run)
{
  run_->takeAll(sinks_);
  recorder_.openNext();
  run_ = std::move(run);
  begin();
}

Outcome RunControl::reset(std::uint64_t seed, const std::vector<std::string>& overrides)
{
  try
  {
    const SceneDefinition scene = readScene(seed, overrides).definition;
    begin(std::make_unique<LiveRun>(scene, parameters_.rates, parameters_.slew_rates, 0.0, scene.duration));
    return {};
  }
  catch (const SceneError& error)
  {
    return failure(error.what());
  }
  catch (const std::invalid_argument& error)
  {
    return failure(source_ + ": " + error.what());
  }
}

template <typename Frame>
void RunControl::show(const Frame& frame)
{
  sinks_.take(frame);
  recorder_.take(frame);
}

void RunControl::resetWorld()
{
  const DriveState base = run_->simulation().base();
  auto run = std::make_unique<LiveRun>(withBase(run_->simulation().scene(), base), parameters_.rates,
                                       parameters_.slew_rates, run_->time(), run_->endTime());
  apply(SetpointKind::INCLINATION, base.commanded_inclination, run->simulation());
  apply(SetpointKind::FREQUENCY, base.commanded_frequency, run->simulation());
  apply(SetpointKind::AMPLITUDE, base.commanded_amplitude, run->simulation());
  begin(std::move(run));
}

Outcome RunControl::pour(const std::string& species, std::size_t count)
{
  if (count < 1 || count > MOST_POURED)
    return failure("count " + std::to_string(count) + ": must be from 1 to " + std::to_string(MOST_POURED));
  const auto& all = run_->simulation().scene().species;
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const SpeciesDefinition& candidate) { return candidate.name == species; });
  if (found == all.end())
    return failure("species " + species + ": there is none of that name");
  try
  {
    run_->simulation().pour(static_cast<std::size_t>(found - all.begin()), count);
  }
  catch (const std::invalid_argument& error)
  {
    return failure(error.what());
  }
  show(run_->particles());
  show(run_->bins());
  return {};
}

Outcome RunControl::command(const Setpoint& setpoint, double value)
{
  if (const auto refusal = setpoint.refusal(value))
    return failure(*refusal);
  apply(setpoint.kind, value, run_->simulation());
  recorder_.takeSetpoint(setpoint.topic(), value, run_->time());
  show(run_->base());
  return {};
}

}  // namespace ratchet_sieve
