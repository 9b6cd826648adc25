#include "ratchet_sieve/recording/headless_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ratchet_sieve/recording/certainty.h"
#include "ratchet_sieve/recording/run.h"
#include "ratchet_sieve/recording/run_warnings.h"
#include "ratchet_sieve/recording/steady.h"
#include "ratchet_sieve/recording/stride.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

using Clock = std::chrono::steady_clock;

/// Time scales of the machine between audits of all disks for overlaps. Audits fall on the same times for
/// every duration, so that a resumed run has those of an uninterrupted one.
constexpr double SCALES_PER_AUDIT = 16.0;

constexpr double NEVER = std::numeric_limits<double>::infinity();

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
        run_(simulation, simulation.scene().duration),
        audit_period_(SCALES_PER_AUDIT * simulation.timeScale())
  {
    outcome_.progress = so_far;
    audits_ = std::floor(simulation.time() / audit_period_);
    if (nextAudit() < simulation.time())
      audits_ += 1.0;
    if (simulation.scene().accuracy.endsEarly())
      next_look_ = lookFrom(simulation, simulation.time());
    if (!watchers_.frames.empty())
      simulation.keepExits(BIN_WINDOW);
    for (const FrameStream& stream : watchers_.frames)
      run_.add(*stream.sink, stream.rates);
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
      // Reported below, as for a run that reached its end.
    }
    if (simulation_.stalled())
      outcome_.end = RunEnd::STALLED;
    const Certainty certainty = certaintyOf(simulation_);
    if (outcome_.end == RunEnd::COMPLETED)
      warnOfErrors(certainty);
    outcome_.steadiness = steadinessOf(simulation_);
    warn(steadyText(simulation_, *outcome_.steadiness, certainty), "not-steady");
    if (outcome_.end == RunEnd::CHOKED)
      warn(fmt::format("ended at {} s of {} s by feed.on_choke", simulation_.time(),
                       simulation_.scene().duration),
           "ended-choked");
    warn(simulation_.collapseText(), "collapse");
    const std::string choke = chokeText(simulation_);
    const bool goes_on = !choke.empty() && simulation_.scene().feed.on_choke == ChokeAction::RUN;
    warn(choke + (goes_on ? "; feed.on_choke: stop ends such a run" : ""), "choked");
    warn(energyText(simulation_), "large-energy");
    warn(overWallsText(simulation_), "over-walls");
    save();
    audit();
    run_.takeAll();
    if (const std::size_t through = outcome_.progress.through_base; through > 0)
      warn(fmt::format("{} {} found below the base's surface", countText(through, "disk"),
                       through == 1 ? "was" : "were"),
           "through-base");
    outcome_.wall_time = secondsSince(start);
    return std::move(outcome_);
  }

private:
  /// @param text of the rule of this id; empty if there is nothing to warn of
  void warn(const std::string& text, const char* id)
  {
    if (!text.empty())
      outcome_.warnings.push_back(withId(text, id));
  }

  void warnOfErrors(const Certainty& certainty)
  {
    outcome_.warnings = shortfalls(simulation_, certainty);
    if (outcome_.warnings.empty())
      warn(unknownErrorText(simulation_), "unknown-error");
  }

  void advanceToEnd()
  {
    const double duration = simulation_.scene().duration;
    lookAtDue();
    while (simulation_.time() < duration && outcome_.end != RunEnd::CHOKED && !accurate())
    {
      if (watchers_.stop_wanted && watchers_.stop_wanted())
      {
        outcome_.end = RunEnd::STOPPED;
        warn(fmt::format("stopped at {:.6g} s of {:g} s", simulation_.time(), duration), "stopped");
        return;
      }
      run_.observePeriods();
      stride_.advance(simulation_, std::min({nextAudit(), run_.nextTime(), next_look_}));
      lookAtDue();
      if (secondsSince(last_save_) >= watchers_.save_period)
        save();
    }
  }

  void lookAtDue()
  {
    if (nextAudit() <= simulation_.time())
    {
      audit();
      ++audits_;
      const SceneDefinition& scene = simulation_.scene();
      if (scene.feed.on_choke == ChokeAction::STOP && simulation_.time() < scene.duration &&
          !chokeText(simulation_).empty())
        outcome_.end = RunEnd::CHOKED;
    }
    run_.takeDue();
    if (watchers_.progress)
      watchers_.progress(simulation_);
  }

  /// Whether the run has reached the accuracy that its scene requests.
  bool accurate()
  {
    if (next_look_ > simulation_.time())
      return false;
    next_look_ = lookFrom(simulation_, std::nextafter(simulation_.time(), NEVER));
    if (!*certaintyOf(simulation_).reached())
      return false;
    outcome_.end = RunEnd::ACCURATE;
    return true;
  }

  double nextAudit() const { return audits_ * audit_period_; }

  void audit()
  {
    std::size_t& most = outcome_.progress.through_base;
    most = std::max(most, simulation_.auditOverlaps());
  }

  /// A stalled run could not be resumed: the previous checkpoint is kept.
  void save()
  {
    if (watchers_.save && !simulation_.stalled())
      watchers_.save(simulation_, outcome_.progress);
    last_save_ = Clock::now();
  }

  Simulation& simulation_;
  const RunWatchers& watchers_;
  Run run_;
  double next_look_ = NEVER;  ///< at the accuracy, if the run may end before its duration [s]
  RunOutcome outcome_;
  Stride stride_;        ///< so that watchers are served in time
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
