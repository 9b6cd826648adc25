#include "running_simulation.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include "ratchet_sieve/live/plant.h"
#include "ratchet_sieve/recording/checkpoint.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds SIGNAL_PERIOD(20);

/// Calls `pour` with an observer that stops it at a signal, with Python's lock let go.
template <typename Pour>
auto stoppable(Pour&& pour)
{
  struct Stopped
  {
  };
  SignalWatch signals;
  try
  {
    const py::gil_scoped_release let_go;
    return pour(
        [&signals](std::size_t, std::size_t)
        {
          if (signals.stopWanted())
            throw Stopped();
        });
  }
  catch (const Stopped&)
  {
    signals.raise();
    throw;
  }
}

const CommandedQuantity& quantityOf(const std::string& name)
{
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
    if (name == quantity.name)
      return quantity;
  throw std::invalid_argument("there is no quantity " + name);
}

void requireWithin(const std::string& name, double value, const Interval& allowed, const std::string& unit)
{
  if (!allowed.contains(value))
    throw std::invalid_argument(
        fmt::format("{} = {}: must be {} to {} {}", name, value, allowed.min, allowed.max, unit));
}

}  // namespace

bool SignalWatch::stopWanted()
{
  if (stop_wanted_ || Clock::now() < next_)
    return stop_wanted_;
  next_ = Clock::now() + SIGNAL_PERIOD;
  const py::gil_scoped_acquire held;
  stop_wanted_ = PyErr_CheckSignals() != 0;
  return stop_wanted_;
}

void SignalWatch::raise() const
{
  if (stop_wanted_)
    throw py::error_already_set();
}

RunningSimulation::Use::Use(RunningSimulation& of) : of_(of)
{
  if (of.in_use_.exchange(true))
    throw std::runtime_error("the simulation is in use by another thread");
}

RunningSimulation::RunningSimulation(std::shared_ptr<Scene> scene, double start_time)
    : scene_(std::move(scene)),
      simulation_(
          stoppable([&](const PourObserver& observer)
                    { return std::make_unique<Simulation>(scene_->definition, start_time, observer); }))
{
}

RunningSimulation::RunningSimulation(std::shared_ptr<Scene> scene, std::string_view saved_state)
    : scene_(std::move(scene)),
      simulation_(std::make_unique<Simulation>(restoreRun(saved_state, scene_->definition)))
{
}

void RunningSimulation::command(const std::map<std::string, double>& setpoints)
{
  for (const auto& [name, setpoint] : setpoints)
    requireWithin(name, setpoint, quantityOf(name).legal, quantityOf(name).unit);
  Use simulation(*this);
  for (const auto& [name, setpoint] : setpoints)
    simulation->command(quantityOf(name).quantity, setpoint);
}

void RunningSimulation::setSlewRates(const SlewRates& rates)
{
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
    requireWithin(std::string(quantity.name) + " (slew rate)", rates.*quantity.slew_rate, quantity.slew_rates,
                  std::string(quantity.unit) + "/s");
  Use(*this)->setSlewRates(rates);
}

void RunningSimulation::pour(std::size_t species, std::size_t count,
                             const std::optional<std::pair<double, double>>& between)
{
  const auto stretch = between ? std::optional(Stretch{between->first, between->second}) : std::nullopt;
  Use simulation(*this);
  stoppable([&](const PourObserver& observer) { simulation->pour(species, count, stretch, observer); });
}

std::vector<Sensor> sensorsFromText(const std::string& yaml, const SceneDefinition& scene, double start_time)
{
  const YAML::Node root = copyWithoutLines(copyableYaml(yaml, "sensors"));
  return makeSensors(readSensors(root, "sensors"), scene, start_time);
}

void RunningSimulation::sense(const std::string& sensors)
{
  Use simulation(*this);
  sensors_ = sensorsFromText(sensors, simulation->scene(), simulation->time());
  simulation->observeExits(
      [this](const ExitRecord& exit)
      {
        for (Sensor& sensor : sensors_)
          sensor.take(exit);
      });
  readDue(sensors_, *simulation);
}

std::vector<double> RunningSimulation::sensed() const
{
  std::vector<double> values;
  for (const Sensor& sensor : sensors_)
    values.insert(values.end(), sensor.sent().values.begin(), sensor.sent().values.end());
  return values;
}

void RunningSimulation::advanceTo(double time, const std::function<bool()>& stop_wanted)
{
  Use simulation(*this);
  while (simulation->time() < time && !stop_wanted())
  {
    stride_.advance(*simulation, std::min(time, nextTime(sensors_)));
    readDue(sensors_, *simulation);
  }
}

}  // namespace ratchet_sieve
