#pragma once

#include <optional>

#include "ratchet_sieve/seeking/inclination_search.h"
#include "ratchet_sieve/seeking/separation_trial.h"

namespace ratchet_sieve
{

/// A completed trial and the resulting decision.
struct SeekReport
{
  unsigned trial = 0;  ///< from 1 on
  SearchPhase phase = SearchPhase::APPROACH;
  Goal goal;  ///< of the search
  Separation separation;
  Score score;        ///< of this trial
  double best = 0.0;  ///< the best inclination known after it [rad]
  Score best_score;   ///< of all counts at `best`
  SearchPhase next_phase = SearchPhase::APPROACH;
  double next = 0.0;  ///< the inclination tried next [rad]
};

/// Searches for the inclination at which a running sieve attains its goal best: takes its frames and returns
/// the setpoint. Independent of topics; the only times it uses are those in the frames.
class SeekControl
{
public:
  /// @param start first inclination [rad]; nothing: the sieve's present one
  SeekControl(const SearchOptions& search, const TrialOptions& trial, std::optional<double> start);

  /// @return a report if the frame ended a trial
  std::optional<SeekReport> take(const BaseFrame& frame);
  std::optional<SeekReport> take(const BinFrame& frame);
  void take(const StatisticsFrame& frame);

  /// Restarts the trial: the sieve was restarted, or replaced by an identical one.
  void interrupt() { trial_.interrupt(); }

  /// Number of restarted trials, including those after a jump back of time or counts.
  unsigned interruptions() const { return trial_.interruptions(); }

  /// Forgets all measurements and restarts the search at the present inclination: the sieve has changed.
  /// Called automatically if the frequency or the amplitude was changed. The search also restarts if the
  /// goal's value decreases.
  void restart();

  /// Number of restarts of the search.
  unsigned restarts() const;

  /// The inclination to command [rad]; nothing before the first frames.
  std::optional<double> setpoint() const;

  /// Whether the sieve's last frame shows this setpoint.
  bool followed() const { return trial_.followed(); }

private:
  std::optional<SeekReport> conclude();

  SearchOptions search_options_;
  std::optional<double> start_;
  std::optional<InclinationSearch> search_;
  SeparationTrial trial_;
  std::optional<DriveState> drive_;  ///< the drive during the measurements
  unsigned trials_ = 0;
};

}  // namespace ratchet_sieve
