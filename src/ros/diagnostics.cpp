#include "ratchet_sieve/ros/diagnostics.h"

#include <algorithm>

namespace ratchet_sieve
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

constexpr std::chrono::duration<double> PERIOD(1.0);

/// Overlaps below this share of the smallest radius are rounding.
constexpr double TOLERATED_OVERLAP = 1e-9;

/// Below this share of the real-time factor that was asked for, the machine is too slow.
constexpr double TOLERATED_SPEED = 0.9;

double smallestRadius(const SceneDefinition& scene)
{
  double smallest = scene.species.front().radius;
  for (const SpeciesDefinition& species : scene.species)
    smallest = std::min(smallest, species.radius);
  return smallest;
}
}  // namespace

Diagnostics::Diagnostics(const RunControl& control, const NodeParameters& parameters,
                         const Recorder& recorder)
    : control_(control), parameters_(parameters), recorder_(recorder)
{
  updater_.setHardwareID("ratchet_sieve");
  updater_.add("simulation", this, &Diagnostics::reportRun);
  updater_.add("setpoints", this, &Diagnostics::reportSetpoints);
  updater_.add("recording", this, &Diagnostics::reportRecording);
}

void Diagnostics::setpointTaken(const Setpoint& setpoint)
{
  refusals_.erase(setpoint.name);
}

void Diagnostics::setpointRefused(const Setpoint& setpoint, const std::string& why)
{
  refusals_[setpoint.name] = why;
  updater_.force_update();
}

void Diagnostics::updateDue()
{
  if (Clock::now() - last_update_ >= PERIOD)
    updater_.force_update();
}

void Diagnostics::reportRun(Status& status)
{
  const auto now = Clock::now();
  const LiveRun& run = control_.run();
  const double wall = std::chrono::duration<double>(now - last_update_).count();
  const double achieved = wall > 0.0 ? (run.time() - last_time_) / wall : 0.0;
  const double asked = parameters_.real_time_factor;
  const Simulation& simulation = run.simulation();
  const double overlap = simulation.maxOverlap();
  last_update_ = now;
  last_time_ = run.time();

  if (simulation.stalled())
    status.summary(DiagnosticStatus::ERROR, simulation.collapseText());
  else if (overlap > TOLERATED_OVERLAP * smallestRadius(simulation.scene()))
    status.summaryf(DiagnosticStatus::ERROR, "disks overlapped by %.3g m", overlap);
  else if (simulation.collapses().count > 0)
    status.summary(DiagnosticStatus::WARN, simulation.collapseText());
  else if (control_.paused())
    status.summary(DiagnosticStatus::OK, run.finished() ? "at its end" : "paused");
  else if (asked > 0.0 && wall >= PERIOD.count() && achieved < TOLERATED_SPEED * asked)
    status.summaryf(DiagnosticStatus::WARN, "too slow: %.3g times real time instead of %.3g", achieved,
                    asked);
  else
    status.summary(DiagnosticStatus::OK, "running");
  status.add("simulated time [s]", run.time());
  status.add("end [s]", run.endTime());
  status.add("real-time factor", achieved);
  status.add("disks in the machine", simulation.activeDisks());
  status.add("events", simulation.events());
  status.add("inelastic collapses", simulation.collapses().count);
  status.add("largest overlap [m]", overlap);
}

void Diagnostics::reportSetpoints(Status& status)
{
  status.summary(DiagnosticStatus::OK, "all setpoints taken");
  for (const auto& [name, why] : refusals_)
    status.mergeSummary(DiagnosticStatus::WARN, why);
  const DriveState base = control_.run().simulation().base();
  status.add("inclination, commanded [rad]", base.commanded_inclination);
  status.add("frequency, commanded [Hz]", base.commanded_frequency);
  status.add("amplitude, commanded [m]", base.commanded_amplitude);
}

void Diagnostics::reportRecording(Status& status)
{
  const std::string path = recorder_.path();
  if (recorder_.failure().empty())
    status.summary(DiagnosticStatus::OK, path.empty() ? "off" : "on");
  else
    status.summary(DiagnosticStatus::ERROR, recorder_.failure());
  status.add("file", path);
  status.add("size of the file [MB]", recorder_.megabytes());
}

}  // namespace ratchet_sieve
