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

double bothErrors(const Score& one, const Score& other)
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

void InclinationSearch::take(const std::vector<SpeciesBins>& bins)
{
  if (phase_ == SearchPhase::HOLD && isWorse(bins))
  {
    if (++drops_ < DROPS)
      return;
    restart();
  }
  drops_ = 0;
  Point& point = at(next_);
  ++point.trials;
  addBins(point.bins, bins);
  if (phase_ == SearchPhase::APPROACH)
    approach();
  if (phase_ == SearchPhase::CLIMB)
    climb();
}

Score InclinationSearch::bestScore() const
{
  for (const Point& point : points_)
    if (point.inclination == centre_)
      return point.score();
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
  const Score score = at(centre_).score();
  if (std::abs(score.balance) <= score.quality)
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
/// Each move is to a higher Q, so that it terminates.
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
  for (const double inclination : inclinations)
  {
    const Point& other = at(inclination);
    const double difference = std::abs(other.score().quality - centre.score().quality);
    if (difference > options_.confidence * bothErrors(other.score(), centre.score()))
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
    if (at(inclination).score().quality > at(best).score().quality)
      best = at(inclination).inclination;
  return best;
}

bool InclinationSearch::isWorse(const std::vector<SpeciesBins>& bins) const
{
  const Score now = scoreOf(bins);
  const Score before = bestScore();
  const double doubt = options_.confidence * bothErrors(now, before);
  return now.quality < before.quality - std::max(options_.drop, doubt);
}

}  // namespace ratchet_sieve
