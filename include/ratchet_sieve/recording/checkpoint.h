#pragma once

#include <stdexcept>
#include <string>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/headless_run.h"

namespace ratchet_sieve
{

/// A checkpoint that cannot be taken up; names the file and says why.
struct CheckpointError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A run as it was saved.
struct Checkpoint
{
  RunProgress progress;
  Simulation simulation;
};

/// Writes a run into a file: whole or not at all, so that what was there before survives whatever
/// ends the program. @throws OutputError
void writeCheckpoint(const std::string& path, const Simulation& simulation, const RunProgress& progress);

/// Takes up a run from a file, to go on bit for bit. `duration` and what decides when a run may end
/// before it (certaintyKeyNames()) may differ from what it was saved with, nothing else of the scene.
/// @throws CheckpointError if the file is no checkpoint, damaged, of another version of the program or
/// of another scene
Checkpoint readCheckpoint(const std::string& path, const SceneDefinition& scene);

}  // namespace ratchet_sieve
