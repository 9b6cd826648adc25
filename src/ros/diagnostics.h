#pragma once

#include <chrono>
#include <map>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>

#include "clock_publisher.h"
#include "node_parameters.h"
#include "ratchet_sieve/live/pacer.h"
#include "ratchet_sieve/live/run_control.h"
#include "recorder.h"

namespace ratchet_sieve
{

/// The sources of a run's speed. All outlive the holder of this struct.
struct Speed
{
  const RealTimeFactor& parameter;
  const Pacer& pacer;
  const SpeedWatch& watch;
};

/// Publishes on /diagnostics, once a second of wall time: the state and the speed of the run, implausible
/// values in its scene, refused setpoints, the state of the recording, and the source of /clock.
class Diagnostics
{
public:
  /// All arguments outlive this.
  Diagnostics(const RunControl& control, const Speed& speed, const Recorder& recorder,
              const ClockPublisher& clock);

  /// A setpoint's or service's last request was refused: shown soon, until one is accepted. @param why empty
  /// if it was accepted
  void answered(const std::string& request, const std::string& why = "");

  /// Publishes if due.
  void updateDue();

private:
  using Clock = std::chrono::steady_clock;
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void reportRun(Status& status);
  void reportScene(Status& status);
  void reportSpeed(Status& status);
  void reportSetpoints(Status& status);
  void reportRecording(Status& status);
  void reportClock(Status& status);

  const RunControl& control_;
  const Speed speed_;
  const Recorder& recorder_;
  const ClockPublisher& clock_;
  std::map<std::string, std::string> refusals_;  ///< of the last request, per setpoint or service
  std::string last_refusal_;                     ///< of the real-time factor, as last shown
  double last_factor_ = 0.0;                     ///< the requested factor, as last shown
  bool pressing_ = false;                        ///< there is something new to show soon
  Clock::time_point last_update_ = Clock::now();
  diagnostic_updater::Updater updater_;
};

}  // namespace ratchet_sieve
