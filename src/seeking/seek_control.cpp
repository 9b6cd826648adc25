#include "ratchet_sieve/seeking/seek_control.h"

namespace ratchet_sieve
{
namespace
{
bool sameDrive(const DriveState& one, const DriveState& other)
{
  return one.commanded_frequency == other.commanded_frequency &&
         one.commanded_amplitude == other.commanded_amplitude;
}
}  // namespace

SeekControl::SeekControl(const SearchOptions& search, const TrialOptions& trial, std::optional<double> start)
    : search_options_(search), start_(start), trial_(trial)
{
}

std::optional<double> SeekControl::setpoint() const
{
  return search_ ? std::optional<double>(search_->next()) : std::nullopt;
}

unsigned SeekControl::restarts() const
{
  return search_ ? search_->restarts() : 0;
}

void SeekControl::restart()
{
  if (search_)
    search_->restart();
  trial_.interrupt();
}

std::optional<SeekReport> SeekControl::take(const BaseFrame& frame)
{
  if (!search_)
  {
    search_.emplace(search_options_, start_.value_or(frame.base.commanded_inclination));
    trial_.begin(search_->next());
  }
  if (drive_ && !sameDrive(*drive_, frame.base))
    restart();
  drive_ = frame.base;
  trial_.take(frame);
  return conclude();
}

std::optional<SeekReport> SeekControl::take(const BinFrame& frame)
{
  trial_.take(frame);
  return conclude();
}

void SeekControl::take(const StatisticsFrame& frame)
{
  trial_.take(frame);
}

std::optional<SeekReport> SeekControl::conclude()
{
  if (!trial_.result())
    return std::nullopt;
  SeekReport report;
  report.trial = ++trials_;
  report.phase = search_->phase();
  report.goal = search_options_.goal;
  report.separation = *trial_.result();
  report.score = scoreOf(report.separation, search_options_.goal);
  search_->take(report.separation);
  report.best = search_->best();
  report.best_score = search_->bestScore();
  report.next_phase = search_->phase();
  report.next = search_->next();
  trial_.begin(report.next);
  return report;
}

}  // namespace ratchet_sieve
