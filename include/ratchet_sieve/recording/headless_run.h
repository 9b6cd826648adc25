#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/recording/run.h"
#include "ratchet_sieve/recording/steady.h"

namespace ratchet_sieve
{

/// Figures of a run that the simulation does not keep.
struct RunProgress
{
  double energy_start = 0.0;     ///< of the disks at time 0 [J]
  std::size_t through_base = 0;  ///< largest number of disks found below the base's surface in one audit
};

/// The progress of a new run.
inline RunProgress firstProgress(Simulation& simulation)
{
  return {simulation.energy(), simulation.auditOverlaps()};
}

/// Why a run ended.
enum class RunEnd
{
  COMPLETED,  ///< reached the scene's duration
  ACCURATE,   ///< reached the accuracy that the scene requests
  CHOKED,     ///< a choked base whose scene says feed.on_choke: stop; see chokeText()
  STOPPED,    ///< stopped by the caller
  STALLED     ///< an inelastic collapse (StallError)
};

/// The result of a run, beside the simulation's state.
struct RunOutcome
{
  RunEnd end = RunEnd::COMPLETED;
  double wall_time = 0.0;  ///< [s]
  RunProgress progress;
  std::vector<std::string> warnings;     ///< one line each
  std::optional<Steadiness> steadiness;  ///< at the end; nothing: not looked for yet
};

/// A sink that takes frames of a run at its own rates.
struct FrameStream
{
  FrameSink* sink;
  FrameRates rates = {};
};

/// Observers of a run; each may be empty.
struct RunWatchers
{
  std::vector<FrameStream> frames;
  std::function<void(const Simulation&)> progress;  ///< several times a second of wall time
  std::function<bool()> stop_wanted;                ///< polled several times a second
  std::function<void(const Simulation&, const RunProgress&)>
      save;                   ///< called every save_period and at the end
  double save_period = 60.0;  ///< of wall time [s]
};

/// Runs the simulation to its scene's duration, to the accuracy that its scene requests or until its base is
/// choked (feed.on_choke), as fast as possible. The results do not depend on how the run is divided into
/// calls of advanceTo(). A run that ends by a collapse is not saved at its end, because it could not be
/// resumed.
RunOutcome runToEnd(Simulation& simulation, const RunWatchers& watchers, const RunProgress& so_far);

/// Runs a new simulation, which has no progress yet.
inline RunOutcome runToEnd(Simulation& simulation, const RunWatchers& watchers)
{
  return runToEnd(simulation, watchers, firstProgress(simulation));
}

}  // namespace ratchet_sieve
