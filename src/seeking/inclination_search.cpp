#include "ratchet_sieve/seeking/inclination_search.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// Inclinations that differ by less than this fraction of the resolution are equal, because steps round.
constexpr double SAME = 0.125;

/// Number of consecutive worse trials that restarts the search; a single one may be chance.
constexpr unsigned DROPS = 2;

double bothErrors(const Measured& one, const Measured& other)
{
  return std::hypot(one.error, other.error);
}
}  // namespace

const char* phaseName(SearchPhase phase)
{
  switch (phase)
  {
    case SearchPhase::APPROACH:
      return "approach";
    case SearchPhase::CLIMB:
      return "climb";
    case SearchPhase::HOLD:
      return "hold";
  }
  return "";
}

InclinationSearch::InclinationSearch(const SearchOptions& options, double start)
    : options_(options), next_(inRange(start)), centre_(next_), step_(options.step)
{
}

void InclinationSearch::restart()
{
  phase_ = SearchPhase::APPROACH;
  centre_ = next_;
  step_ = options_.step;
  direction_ = 0.0;
  drops_ = 0;
  points_.clear();
  ++restarts_;
}

void InclinationSearch::take(const Outflow& outflow)
{
  if (phase_ == SearchPhase::HOLD && isWorse(outflow))
  {
    if (++drops_ < DROPS)
      return;
    restart();
  }
  drops_ = 0;
  Point& point = at(next_);
  ++point.trials;
  point.outflow.add(outflow);
  if (phase_ == SearchPhase::APPROACH)
    approach();
  if (phase_ == SearchPhase::CLIMB)
    climb();
}

Score InclinationSearch::bestScore() const
{
  for (const Point& point : points_)
    if (point.inclination == centre_)
      return scoreAt(point);
  return {};
}

InclinationSearch::Point& InclinationSearch::at(double inclination)
{
  const auto found =
      std::find_if(points_.begin(), points_.end(),
                   [&](const Point& point)
                   { return std::abs(point.inclination - inclination) < SAME * options_.resolution; });
  if (found != points_.end())
    return *found;
  points_.push_back({inclination, 0, {}});
  return points_.back();
}

double InclinationSearch::inRange(double inclination) const
{
  return std::clamp(inclination, options_.min, options_.max);
}

/// One step up where most disks leave right, down where most leave left; half a step where the direction
/// reverses.
void InclinationSearch::approach()
{
  const Score score = scoreAt(at(centre_));
  if (std::abs(score.balance) <= score.quality.value)
    return beginClimb();
  const double direction = score.balance > 0.0 ? 1.0 : -1.0;
  if (direction * direction_ < 0.0)
    step_ /= 2.0;
  direction_ = direction;
  const double further = inRange(centre_ + direction * step_);
  if (step_ < options_.resolution || further == centre_)
    return beginClimb();
  centre_ = next_ = at(further).inclination;
}

void InclinationSearch::beginClimb()
{
  phase_ = SearchPhase::CLIMB;
  step_ = std::max(step_, options_.resolution);
}

/// Moves to better inclinations among those measured, until another trial is needed or the best is found.
/// Each move is to a higher value, so that it terminates.
void InclinationSearch::climb()
{
  while (step_ >= options_.resolution)
  {
    const std::vector<double> around = neighbours();
    std::optional<double> needed = untried(around);
    if (!needed)
      needed = uncertain(around);
    if (needed)
    {
      next_ = *needed;
      return;
    }
    const double best = bestOf(around);
    if (best == centre_)
      step_ /= 2.0;
    centre_ = best;
  }
  hold();
}

void InclinationSearch::hold()
{
  phase_ = SearchPhase::HOLD;
  next_ = centre_;
}

/// The inclinations one step away on both sides, clamped to the range; first the one indicated by the
/// balance.
std::vector<double> InclinationSearch::neighbours() const
{
  const double direction = bestScore().balance < 0.0 ? -1.0 : 1.0;
  std::vector<double> inclinations;
  for (const double side : {direction, -direction})
  {
    const double inclination = inRange(centre_ + side * step_);
    if (std::abs(inclination - centre_) >= SAME * options_.resolution)
      inclinations.push_back(inclination);
  }
  return inclinations;
}

std::optional<double> InclinationSearch::untried(const std::vector<double>& inclinations)
{
  for (const double inclination : inclinations)
    if (at(inclination).trials == 0)
      return at(inclination).inclination;
  return std::nullopt;
}

/// The inclination to try again because its difference from the centre is not significant: the one with the
/// larger error. Only at the smallest step: two similar inclinations are on both sides of the best one, and
/// half a step gains more than another trial.
std::optional<double> InclinationSearch::uncertain(const std::vector<double>& inclinations)
{
  if (step_ / 2.0 >= options_.resolution)
    return std::nullopt;
  const Point centre = at(centre_);
  const Measured there = scoreAt(centre).goal;
  for (const double inclination : inclinations)
  {
    const Point& other = at(inclination);
    const Measured here = scoreAt(other).goal;
    if (std::abs(here.value - there.value) > options_.confidence * bothErrors(here, there))
      continue;
    const Point& lesser = other.trials < centre.trials ? other : centre;
    if (lesser.trials < options_.most_trials)
      return lesser.inclination;
  }
  return std::nullopt;
}

double InclinationSearch::bestOf(const std::vector<double>& inclinations)
{
  double best = centre_;
  for (const double inclination : inclinations)
    if (scoreAt(at(inclination)).goal.value > scoreAt(at(best)).goal.value)
      best = at(inclination).inclination;
  return best;
}

bool InclinationSearch::isWorse(const Outflow& outflow) const
{
  const Measured now = measured(options_.goal, outflow);
  const Measured before = bestScore().goal;
  const double drop = options_.drop * (options_.goal.isShare() ? 1.0 : before.value);
  return now.value < before.value - std::max(drop, options_.confidence * bothErrors(now, before));
}

}  // namespace ratchet_sieve
