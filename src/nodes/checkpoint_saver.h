#pragma once

#include <string>

#include "ratchet_sieve/recording/checkpoint.h"

namespace ratchet_sieve
{

/// Saves a run periodically. A full disk does not end the run, but causes a warning.
class CheckpointSaver
{
public:
  /// Saves the start of the run, so that a bad path is an error before any work is done.
  /// @throws OutputError
  CheckpointSaver(const std::string& path, const Simulation& simulation, const RunProgress& progress);

  void save(const Simulation& simulation, const RunProgress& progress);

  /// Whether the last checkpoint was saved.
  bool saved() const { return failure_.empty(); }

private:
  std::string path_;
  std::string failure_;
};

}  // namespace ratchet_sieve
