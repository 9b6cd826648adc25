#include "diagnostics.h"

#include <algorithm>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/recording/run_warnings.h"
#include "ratchet_sieve/scene/scene_text.h"

namespace ratchet_sieve
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

constexpr std::chrono::duration<double> PERIOD(1.0);

/// A new problem is shown earlier, but not more often than this: thousands of bad setpoints may arrive.
constexpr std::chrono::duration<double> PRESSING_PERIOD(0.1);

/// Overlaps below this fraction of the smallest radius are rounding.
constexpr double TOLERATED_OVERLAP = 1e-9;

}  // namespace

Diagnostics::Diagnostics(const RunControl& control, const Speed& speed, const Recorder& recorder,
                         const ClockPublisher& clock)
    : control_(control), speed_(speed), recorder_(recorder), clock_(clock)
{
  updater_.setHardwareID(ros::this_node::getName().substr(1));
  updater_.add("simulation", this, &Diagnostics::reportRun);
  updater_.add("scene", this, &Diagnostics::reportScene);
  updater_.add("speed", this, &Diagnostics::reportSpeed);
  updater_.add("setpoints", this, &Diagnostics::reportSetpoints);
  updater_.add("recording", this, &Diagnostics::reportRecording);
  updater_.add("clock", this, &Diagnostics::reportClock);
}

void Diagnostics::answered(const std::string& request, const std::string& why)
{
  refusals_.erase(request);
  if (why.empty())
    return;
  refusals_[request] = why;
  pressing_ = true;
}

void Diagnostics::updateDue()
{
  const auto waited = Clock::now() - last_update_;
  pressing_ =
      pressing_ || speed_.parameter.refusal() != last_refusal_ || speed_.pacer.factor() != last_factor_;
  if (waited < (pressing_ ? PRESSING_PERIOD : PERIOD))
    return;
  pressing_ = false;
  last_refusal_ = speed_.parameter.refusal();
  last_factor_ = speed_.pacer.factor();
  last_update_ = Clock::now();
  updater_.force_update();
}

void Diagnostics::reportRun(Status& status)
{
  const Run& run = control_.run();
  const Simulation& simulation = run.simulation();
  const double overlap = simulation.maxOverlap();
  if (simulation.stalled())
    status.summary(DiagnosticStatus::ERROR, simulation.collapseText());
  else if (overlap > TOLERATED_OVERLAP * smallestRadius(simulation.scene()))
    status.summaryf(DiagnosticStatus::ERROR, "disks overlapped by %.3g m", overlap);
  else if (simulation.collapses().count > 0)
    status.summary(DiagnosticStatus::WARN, simulation.collapseText());
  else if (const std::string energy = energyText(simulation); !energy.empty())
    status.summary(DiagnosticStatus::WARN, energy);
  else if (control_.paused())
    status.summary(DiagnosticStatus::OK, run.finished() ? "finished" : "paused");
  else
    status.summary(DiagnosticStatus::OK, "running");
  if (const std::string text = overWallsText(simulation); !text.empty())
    status.mergeSummary(DiagnosticStatus::WARN, text);
  if (const auto refusal = refusals_.find("reset_world"); refusal != refusals_.end())
    status.mergeSummary(DiagnosticStatus::WARN, "reset_world: " + refusal->second);
  status.add("simulated time [s]", run.time());
  status.add("end [s]", run.endTime());
  status.add("disks in the machine", simulation.activeDisks());
  status.add("events", simulation.events());
  status.add("inelastic collapses", simulation.collapses().count);
  status.add("largest energy of a disk [of the machine's scale]", simulation.largestEnergy());
  status.add("largest overlap [m]", overlap);
}

void Diagnostics::reportScene(Status& status)
{
  status.summary(DiagnosticStatus::OK, "plausible");
  for (const std::string& warning : control_.sceneWarnings())
    status.mergeSummary(DiagnosticStatus::WARN, warning);
  status.add("size", sizeText(control_.run().simulation().scene()));
}

void Diagnostics::reportSpeed(Status& status)
{
  const double asked = speed_.pacer.factor();
  const std::optional<double> achieved = speed_.watch.achieved();
  if (control_.paused())
    status.summary(DiagnosticStatus::OK, "paused");
  else if (speed_.watch.behind())
    status.summary(DiagnosticStatus::WARN, tooSlowText(*achieved, asked));
  else
    status.summary(DiagnosticStatus::OK, asked > 0.0 ? "keeps up" : "as fast as possible");
  if (!speed_.parameter.refusal().empty())
    status.mergeSummary(DiagnosticStatus::WARN, speed_.parameter.refusal());
  status.add("real-time factor, requested", asked);
  if (achieved)
    status.add("real-time factor, achieved", *achieved);
  else
    status.add("real-time factor, achieved", "not measured yet");
  status.add("wall time lost [s]", speed_.pacer.lost());
}

void Diagnostics::reportSetpoints(Status& status)
{
  status.summary(DiagnosticStatus::OK, "all setpoints taken");
  for (const auto& [name, why] : refusals_)
    if (name != "reset_world")
      status.mergeSummary(DiagnosticStatus::WARN, why);
  if (const std::string text = control_.turnWarning(); !text.empty())
    status.mergeSummary(DiagnosticStatus::WARN, text);
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

void Diagnostics::reportClock(Status& status)
{
  if (!clock_.conflict().empty())
    status.summary(DiagnosticStatus::WARN, clock_.conflict());
  else
    status.summary(DiagnosticStatus::OK, clock_.enabled() ? "this node publishes /clock" : "off");
  if (!clock_.enabled() && ros::Time::isSimTime())
    status.add("simulated time minus /clock [s]", control_.run().time() - ros::Time::now().toSec());
}

}  // namespace ratchet_sieve
