#pragma once

#include <optional>

#include "ratchet_sieve/seeking/inclination_search.h"
#include "ratchet_sieve/seeking/separation_trial.h"

namespace ratchet_sieve
{

/// A trial that is over, and what was decided upon it.
struct SeekReport
{
  unsigned trial = 0;  ///< from 1 on
  SearchPhase phase = SearchPhase::APPROACH;
  Separation separation;
  Score score;        ///< of this trial
  double best = 0.0;  ///< the best inclination known after it [rad]
  Score best_score;   ///< of all that left there
  SearchPhase next_phase = SearchPhase::APPROACH;
  double next = 0.0;  ///< the inclination tried next [rad]
};

/// Seeks the inclination at which a sieve separates best, while it runs: takes its frames, says how its
/// base is to be commanded. Knows nothing of topics, and of no time but that in the frames.
class SeekControl
{
public:
  /// @param start where to begin [rad]; nothing: where the sieve is
  SeekControl(const SearchOptions& search, const TrialOptions& trial, std::optional<double> start);

  /// @return a report, where the frame ended a trial
  std::optional<SeekReport> take(const BaseFrame& frame);
  std::optional<SeekReport> take(const BinFrame& frame);
  void take(const StatisticsFrame& frame);

  /// Begins the trial again: the sieve was away, or is another one of the same kind.
  void interrupt() { trial_.interrupt(); }

  /// How often that was so, or the sieve's time or counts went back.
  unsigned interruptions() const { return trial_.interruptions(); }

  /// Forgets all that was measured, and seeks again from where it is: the sieve is of another kind. It does
  /// so of itself where somebody changed the frequency or the amplitude, and where Q drops.
  void restart();

  /// How often it did.
  unsigned restarts() const;

  /// The inclination that the sieve has to be commanded to [rad]; nothing before its frames came.
  std::optional<double> setpoint() const;

  /// Whether the sieve, as last received, is commanded to it.
  bool followed() const { return trial_.followed(); }

private:
  std::optional<SeekReport> conclude();

  SearchOptions search_options_;
  std::optional<double> start_;
  std::optional<InclinationSearch> search_;
  SeparationTrial trial_;
  std::optional<DriveState> drive_;  ///< as the measurements were taken with it
  unsigned trials_ = 0;
};

}  // namespace ratchet_sieve
