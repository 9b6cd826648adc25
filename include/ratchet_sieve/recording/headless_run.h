#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/frame_sampler.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// What a run has seen so far that its simulation does not know.
struct RunProgress
{
  double energy_start = 0.0;     ///< of the disks at time 0 [J]
  std::size_t through_base = 0;  ///< disks found behind the base's surface, the most at one audit
};

/// Of a run that begins.
inline RunProgress firstProgress(Simulation& simulation)
{
  return {simulation.energy(), simulation.auditOverlaps()};
}

/// How a run came to its end.
enum class RunEnd
{
  COMPLETED,  ///< the scene's duration
  ACCURATE,   ///< before that, as sure as the scene asks for
  STOPPED,    ///< as asked
  STALLED     ///< time all but stopped (StallError)
};

/// What a run leaves behind besides the simulation's state.
struct RunOutcome
{
  RunEnd end = RunEnd::COMPLETED;
  double wall_time = 0.0;  ///< [s]
  RunProgress progress;
  std::vector<std::string> warnings;  ///< one line each
};

/// The observers of a run under way; each may be empty.
struct RunWatchers
{
  FrameSink* frames = nullptr;  ///< takes frames at `rates`
  FrameRates rates;
  std::function<void(const Simulation&)> progress;                  ///< several times a second of wall time
  std::function<bool()> stop_wanted;                                ///< asked several times a second
  std::function<void(const Simulation&, const RunProgress&)> save;  ///< now and then, and at the end
  double save_period = 60.0;                                        ///< of wall time [s]
};

/// Runs the simulation to its scene's duration, or until it is as sure as its scene asks for, as fast as it
/// goes. In which strides does not matter to its course. A run that stalls is not saved at its end: it could
/// not go on from there.
RunOutcome runToEnd(Simulation& simulation, const RunWatchers& watchers, const RunProgress& so_far);

/// Of a run that begins here.
inline RunOutcome runToEnd(Simulation& simulation, const RunWatchers& watchers)
{
  return runToEnd(simulation, watchers, firstProgress(simulation));
}

}  // namespace ratchet_sieve
