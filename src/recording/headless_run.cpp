#include "ratchet_sieve/recording/headless_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace ratchet_sieve
{
namespace
{

using Clock = std::chrono::steady_clock;

constexpr double FIRST_STRIDE = 1e-3;  ///< of simulated time [s]
constexpr double SHORT_STRIDE = 0.02;  ///< of wall time: shorter ones are lengthened [s]
constexpr double LONG_STRIDE = 0.08;   ///< of wall time: longer ones are shortened [s]

/// All disks are looked over for overlaps so many time scales of the machine apart: at the same
/// times for every duration, so that a run that is taken up sees what it would have seen.
constexpr double SCALES_PER_AUDIT = 16.0;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class HeadlessRun
{
public:
  HeadlessRun(Simulation& simulation, const RunWatchers& watchers, const RunProgress& so_far)
      : simulation_(simulation),
        watchers_(watchers),
        sampler_(watchers.rates, 0.0),
        audit_period_(SCALES_PER_AUDIT * simulation.timeScale())
  {
    outcome_.progress = so_far;
    audits_ = std::floor(simulation.time() / audit_period_) + 1.0;
  }

  RunOutcome run()
  {
    const Clock::time_point start = Clock::now();
    try
    {
      advanceToEnd();
    }
    catch (const StallError&)
    {
      // Told below, as for a run that came to its end all the same.
    }
    if (simulation_.stalled())
      outcome_.end = RunEnd::STALLED;
    if (simulation_.collapses().count > 0)
      outcome_.warnings.push_back(simulation_.collapseText());
    if (const std::string text = simulation_.energyText(); !text.empty())
      outcome_.warnings.push_back(text);
    save();
    audit();
    if (watchers_.frames != nullptr)
      sampler_.takeLast(simulation_, *watchers_.frames);
    if (outcome_.progress.through_base > 0)
      outcome_.warnings.push_back(
          fmt::format("{} disks were found behind the base's surface", outcome_.progress.through_base));
    outcome_.wall_time = secondsSince(start);
    return std::move(outcome_);
  }

private:
  void advanceToEnd()
  {
    const double duration = simulation_.scene().duration;
    lookAtDue();
    while (simulation_.time() < duration)
    {
      if (watchers_.stop_wanted && watchers_.stop_wanted())
      {
        outcome_.end = RunEnd::STOPPED;
        outcome_.warnings.push_back(fmt::format("stopped at {} s of {} s", simulation_.time(), duration));
        return;
      }
      stride(std::min({simulation_.time() + stride_, nextAudit(), nextFrame(), duration}));
      lookAtDue();
      if (secondsSince(last_save_) >= watchers_.save_period)
        save();
    }
  }

  /// Advances, and learns how far to go at once for watchers to be served in good time.
  void stride(double until)
  {
    const Clock::time_point start = Clock::now();
    const bool full = until >= simulation_.time() + stride_;
    simulation_.advanceTo(until);
    const double taken = secondsSince(start);
    if (taken > LONG_STRIDE)
      stride_ *= 0.5;
    else if (full && taken < SHORT_STRIDE)
      stride_ *= 2.0;
  }

  void lookAtDue()
  {
    if (nextAudit() <= simulation_.time())
    {
      audit();
      ++audits_;
    }
    if (watchers_.frames != nullptr)
      sampler_.takeDue(simulation_, *watchers_.frames);
    if (watchers_.progress)
      watchers_.progress(simulation_);
  }

  double nextAudit() const { return audits_ * audit_period_; }

  double nextFrame() const
  {
    return watchers_.frames != nullptr ? sampler_.nextTime() : std::numeric_limits<double>::infinity();
  }

  void audit()
  {
    std::size_t& most = outcome_.progress.through_base;
    most = std::max(most, simulation_.auditOverlaps());
  }

  /// A run that stalls could not go on from there: what was saved before is worth more. An ensemble is
  /// stalled for a while before it is stopped.
  void save()
  {
    if (watchers_.save && !simulation_.stalled())
      watchers_.save(simulation_, outcome_.progress);
    last_save_ = Clock::now();
  }

  Simulation& simulation_;
  const RunWatchers& watchers_;
  FrameSampler sampler_;
  RunOutcome outcome_;
  double stride_ = FIRST_STRIDE;
  double audit_period_;  ///< [s]
  double audits_ = 0.0;
  Clock::time_point last_save_ = Clock::now();
};

}  // namespace

RunOutcome runToEnd(Simulation& simulation, const RunWatchers& watchers, const RunProgress& so_far)
{
  return HeadlessRun(simulation, watchers, so_far).run();
}

}  // namespace ratchet_sieve
