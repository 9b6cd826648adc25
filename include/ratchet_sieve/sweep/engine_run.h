#pragma once

#include "ratchet_sieve/sweep/engine.h"
#include "ratchet_sieve/sweep/sweep_run.h"

namespace ratchet_sieve
{

/// Runs the cases of a sweep that have no result in the file, through an engine. Writes them to case files,
/// stores the results as they arrive, and resubmits missing cases when the engine has ended. A case that ran
/// twice counts once.
/// @throws SceneError, DatabaseError, EngineError; results received before are stored
SweepOutcome runSweepOn(SweepEngine& engine, const Sweep& sweep, const std::string& results,
                        const SweepRunOptions& options);

}  // namespace ratchet_sieve
