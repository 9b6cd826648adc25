#pragma once

#include "ratchet_sieve/sweep/engine.h"
#include "ratchet_sieve/sweep/sweep_run.h"

namespace ratchet_sieve
{

/// Runs the cases of a sweep of which the file has no result by an engine: writes them into files, gathers
/// the results as they come, and hands over again what is missing when the engine has ended. A case that ran
/// twice counts once.
/// @throws SceneError, DatabaseError, EngineError; what came back until then is in the file
SweepOutcome runSweepOn(Engine& engine, const Sweep& sweep, const std::string& results,
                        const SweepRunOptions& options);

}  // namespace ratchet_sieve
