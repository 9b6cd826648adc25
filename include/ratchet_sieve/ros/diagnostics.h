#pragma once

#include <chrono>
#include <map>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>

#include "ratchet_sieve/ros/run_control.h"

namespace ratchet_sieve
{

/// Says on /diagnostics how the run goes, which setpoints were refused and what is recorded, once a
/// second of wall time.
class Diagnostics
{
public:
  /// All outlive this.
  Diagnostics(const RunControl& control, const NodeParameters& parameters, const Recorder& recorder);

  /// A setpoint was taken: what was wrong with an earlier one is past.
  void setpointTaken(const Setpoint& setpoint);

  /// A setpoint was refused: shown at once, and until one is taken.
  void setpointRefused(const Setpoint& setpoint, const std::string& why);

  /// Publishes, if it is time to.
  void updateDue();

private:
  using Clock = std::chrono::steady_clock;
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void reportRun(Status& status);
  void reportSetpoints(Status& status);
  void reportRecording(Status& status);

  const RunControl& control_;
  const NodeParameters& parameters_;
  const Recorder& recorder_;
  std::map<std::string, std::string> refusals_;  ///< per setpoint, the last
  Clock::time_point last_update_ = Clock::now();
  double last_time_ = 0.0;  ///< simulated, at the last update [s]
  diagnostic_updater::Updater updater_;
};

}  // namespace ratchet_sieve
