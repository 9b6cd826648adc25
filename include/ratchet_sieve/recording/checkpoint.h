#pragma once

#include <stdexcept>
#include <string>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/headless_run.h"

namespace ratchet_sieve
{

/// A checkpoint that cannot be read. The message names the file and the reason.
struct CheckpointError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A saved run.
struct Checkpoint
{
  RunProgress progress;
  Simulation simulation;
};

/// Writes a checkpoint, completely or not at all: the previous file stays intact even if interrupted. @throws
/// OutputError
void writeCheckpoint(const std::string& path, const Simulation& simulation, const RunProgress& progress);

/// Reads a checkpoint, from which the run continues bit for bit. Only `duration` and the keys of
/// certaintyKeyNames() of the scene may differ from the saved scene.
/// @throws CheckpointError if the file is no checkpoint, is damaged, or is of another version of the program
/// or of another scene
Checkpoint readCheckpoint(const std::string& path, const SceneDefinition& scene);

}  // namespace ratchet_sieve
