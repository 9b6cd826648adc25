#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/seeking/separation.h"

namespace ratchet_sieve
{

/// What to maximise, and the range and step sizes of the search for the best inclination.
struct SearchOptions
{
  Goal goal;
  double min = -0.5;         ///< smallest inclination tried [rad]
  double max = 0.5;          ///< largest inclination tried [rad]
  double step = 0.1;         ///< first step [rad]
  double resolution = 0.02;  ///< smallest step [rad]
  double confidence = 1.5;   ///< standard errors by which an inclination must be better
  unsigned most_trials = 3;  ///< at one inclination while the comparison is undecided
  double drop = 0.15;        ///< decrease below the best that restarts the search; of a flow: relative to it
};

enum class SearchPhase
{
  APPROACH,  ///< nearly all disks leave at one end: tilts against it
  CLIMB,     ///< compares an inclination with both neighbours
  HOLD       ///< the best inclination is found and monitored
};

const char* phaseName(SearchPhase phase);

/// Decides which inclination of a sieve to try next, from what left at the inclinations tried so far.
///
/// Far from the best inclination, no goal gives a direction: Q is near 0 wherever both species leave at the
/// same end, and no other goal changes there either. The counts do: raising an end sends more disks to the
/// other end. So the search first tilts in steps against the end at which most disks leave, until the species
/// separate more than they move together. Then it compares the inclination with its neighbours one step away
/// and moves to a better one. If neither is better, it halves the step, down to the resolution. Counts at the
/// same inclination are added, so that an undecided comparison becomes more certain with each trial. The
/// search always ends, because an inclination is tried at most `most_trials` times before it is held.
///
/// The held inclination is monitored. The search restarts there if two trials in a row are worse than all
/// earlier ones by more than `drop`, and significantly so.
class InclinationSearch
{
public:
  /// @param start first inclination, clamped to the range [rad]
  InclinationSearch(const SearchOptions& options, double start);

  /// The inclination of the next trial, in [min, max] [rad]. It may be the same as before.
  double next() const { return next_; }

  /// Takes what left in a trial at next().
  void take(const Outflow& outflow);

  /// Forgets all counts and restarts the search at next(), because the sieve has changed.
  void restart();

  /// Number of restarts, for any reason.
  unsigned restarts() const { return restarts_; }

  SearchPhase phase() const { return phase_; }

  /// The best inclination so far; in the phase HOLD, the held one [rad].
  double best() const { return centre_; }

  /// The score of all counts at best().
  Score bestScore() const;

private:
  /// The sum of all trials at one inclination.
  struct Point
  {
    double inclination = 0.0;
    unsigned trials = 0;
    Outflow outflow;
  };

  Point& at(double inclination);
  void approach();
  void climb();
  void beginClimb();
  void hold();
  Score scoreAt(const Point& point) const { return scoreOf(point.outflow, options_.goal); }
  bool isWorse(const Outflow& outflow) const;
  double inRange(double inclination) const;
  std::vector<double> neighbours() const;
  std::optional<double> untried(const std::vector<double>& inclinations);
  std::optional<double> uncertain(const std::vector<double>& inclinations);
  double bestOf(const std::vector<double>& inclinations);

  SearchOptions options_;
  SearchPhase phase_ = SearchPhase::APPROACH;
  double next_;
  double centre_;
  double step_;
  double direction_ = 0.0;  ///< of the last step of the phase APPROACH: 1 up, -1 down, 0 before it
  unsigned drops_ = 0;      ///< number of consecutive trials worse than the held inclination
  unsigned restarts_ = 0;
  std::vector<Point> points_;
};

}  // namespace ratchet_sieve
