#include "ratchet_sieve/recording/headless_run.h"

#include <algorithm>
#include <chrono>
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

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class HeadlessRun
{
public:
  HeadlessRun(Simulation& simulation, const RunWatchers& watchers)
      : simulation_(simulation), watchers_(watchers), sampler_(watchers.rates, simulation.time())
  {
  }

  RunOutcome run()
  {
    const Clock::time_point start = Clock::now();
    outcome_.energy_start = simulation_.energy();
    try
    {
      advanceToEnd();
    }
    catch (const StallError& error)
    {
      outcome_.end = RunEnd::STALLED;
      outcome_.warnings.push_back(error.what());
    }
    audit();
    if (watchers_.frames != nullptr)
      sampler_.takeLast(simulation_, *watchers_.frames);
    if (outcome_.through_base > 0)
      outcome_.warnings.push_back(
          fmt::format("{} disks were found behind the base's surface", outcome_.through_base));
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

  double nextAudit() const { return simulation_.scene().duration * audits_ / AUDITS_PER_RUN; }

  double nextFrame() const
  {
    return watchers_.frames != nullptr ? sampler_.nextTime() : std::numeric_limits<double>::infinity();
  }

  void audit() { outcome_.through_base = std::max(outcome_.through_base, simulation_.auditOverlaps()); }

  Simulation& simulation_;
  const RunWatchers& watchers_;
  FrameSampler sampler_;
  RunOutcome outcome_;
  double stride_ = FIRST_STRIDE;
  int audits_ = 0;
};

}  // namespace

RunOutcome runToEnd(Simulation& simulation, const RunWatchers& watchers)
{
  return HeadlessRun(simulation, watchers).run();
}

}  // namespace ratchet_sieve
