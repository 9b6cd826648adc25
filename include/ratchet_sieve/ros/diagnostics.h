#pragma once

#include <chrono>
#include <map>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>

#include "ratchet_sieve/live/pacer.h"
#include "ratchet_sieve/live/run_control.h"
#include "ratchet_sieve/live/speed_watch.h"
#include "ratchet_sieve/ros/clock_publisher.h"
#include "ratchet_sieve/ros/real_time_factor.h"
#include "ratchet_sieve/ros/recorder.h"

namespace ratchet_sieve
{

/// What is known of the speed of a run. All outlive who holds this.
struct Speed
{
  const RealTimeFactor& parameter;
  const Pacer& pacer;
  const SpeedWatch& watch;
};

/// Says on /diagnostics how the run goes and how fast, what of its scene can hardly be meant, which setpoints
/// were refused, what is recorded and who is the clock, once a second of wall time.
class Diagnostics
{
public:
  /// All outlive this.
  Diagnostics(const RunControl& control, const Speed& speed, const Recorder& recorder,
              const ClockPublisher& clock);

  /// A setpoint was taken: what was wrong with an earlier one is past.
  void setpointTaken(const Setpoint& setpoint);

  /// A setpoint was refused: shown soon, and until one is taken.
  void setpointRefused(const Setpoint& setpoint, const std::string& why);

  /// No new disks were poured: shown soon, and until a run begins.
  void resetWorldRefused(const std::string& why);

  /// A run begins.
  void begunAnew() { reset_world_refusal_.clear(); }

  /// Publishes, if it is time to.
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
  std::map<std::string, std::string> refusals_;  ///< per setpoint, the last
  std::string reset_world_refusal_;
  std::string last_refusal_;  ///< of the real-time factor, as it was last shown
  double last_factor_ = 0.0;  ///< asked for, as it was last shown
  bool pressing_ = false;     ///< there is something new to show
  Clock::time_point last_update_ = Clock::now();
  diagnostic_updater::Updater updater_;
};

}  // namespace ratchet_sieve
