#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

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

/// The state of a simulation with the scene that it belongs to, as bytes.
std::string saveRun(const Simulation& simulation);

/// Resumes such a state bit for bit. Only `duration` and the keys of certaintyKeyNames() of the scene may
/// differ from the saved scene.
/// @throws StateError if the bytes are none, are damaged, or are of another version of the program than this
/// and its patches, or of another scene; then the message names both versions, or the key
Simulation restoreRun(std::string_view saved, const SceneDefinition& scene);

/// Writes a checkpoint, completely or not at all: the previous file stays intact even if interrupted. @throws
/// OutputError
void writeCheckpoint(const std::string& path, const Simulation& simulation, const RunProgress& progress);

/// Reads a checkpoint, from which the run continues as after restoreRun(). @throws CheckpointError if the
/// file is no checkpoint, is damaged, or is of another version of the program or of another scene
Checkpoint readCheckpoint(const std::string& path, const SceneDefinition& scene);

}  // namespace ratchet_sieve
