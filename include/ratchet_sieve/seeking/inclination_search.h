#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/seeking/separation.h"

namespace ratchet_sieve
{

/// Where and how finely the best inclination is sought.
struct SearchOptions
{
  double min = -0.5;         ///< least inclination tried [rad]
  double max = 0.5;          ///< greatest inclination tried [rad]
  double step = 0.1;         ///< first step [rad]
  double resolution = 0.02;  ///< steps are no smaller [rad]
  double confidence = 1.5;   ///< standard errors by which one inclination has to be better at once
  unsigned most_trials = 3;  ///< at one inclination, as long as it is not surely better or worse
  double drop = 0.15;        ///< of Q below that of the best: seek again
};

enum class SearchPhase
{
  APPROACH,  ///< nearly all goes to one end: tilts against it
  CLIMB,     ///< compares an inclination with its neighbours on both sides
  HOLD       ///< the best is found, and watched
};

const char* phaseName(SearchPhase phase);

/// Decides which inclination of a sieve to try next, from what left it at those tried before.
///
/// Far from the best inclination Q says nothing: it is near 0 wherever both species leave by one end. But
/// then it is known where to go: tilting an end up makes more go to the other. So it first tilts in
/// steps, against where most goes, until the species part more than they go one way together. Then it
/// compares the inclination with its neighbours one step away, moves to a better one, and halves the step
/// when there is none, down to the resolution. Whatever left at one inclination is counted together, so that
/// what is uncertain becomes surer with each trial there. It comes to an end whatever it is given: an
/// inclination is tried at most `most_trials` times before it is held.
///
/// What it holds it goes on watching: two trials in a row that are worse than all those before by more
/// than `drop`, and not by chance, and it seeks again from there.
class InclinationSearch
{
public:
  /// @param start the inclination to begin at; taken into the range if it is not there [rad]
  InclinationSearch(const SearchOptions& options, double start);

  /// The inclination to try, again and again: in [min, max] [rad].
  double next() const { return next_; }

  /// What left at next().
  void take(const std::vector<SpeciesBins>& bins);

  /// Forgets all that left: the sieve is no longer the same. Seeks again from next().
  void restart();

  /// How often it began to seek again, for whatever reason.
  unsigned restarts() const { return restarts_; }

  SearchPhase phase() const { return phase_; }

  /// The best inclination so far: while it holds, the one held [rad].
  double best() const { return centre_; }

  /// Of all that left at best().
  Score bestScore() const;

private:
  /// All trials at one inclination.
  struct Point
  {
    double inclination = 0.0;
    unsigned trials = 0;
    std::vector<SpeciesBins> bins;

    Score score() const { return scoreOf(bins); }
  };

  Point& at(double inclination);
  void approach();
  void climb();
  void beginClimb();
  void hold();
  bool isWorse(const std::vector<SpeciesBins>& bins) const;
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
  double direction_ = 0.0;  ///< of the last step of the approach: 1 up, -1 down, 0 before it
  unsigned drops_ = 0;      ///< trials in a row that were worse than what is held
  unsigned restarts_ = 0;
  std::vector<Point> points_;
};

}  // namespace ratchet_sieve
