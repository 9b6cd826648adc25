#pragma once

#include <string>

#include "ratchet_sieve/recording/checkpoint.h"

namespace ratchet_sieve
{

/// Saves a run as it goes. A disk that is full for a while does not end it: standard error says so.
class CheckpointSaver
{
public:
  /// Saves the run as it begins: whatever is wrong with the path shows before any work is done.
  /// @throws OutputError
  CheckpointSaver(const std::string& path, const Simulation& simulation, const RunProgress& progress);

  void save(const Simulation& simulation, const RunProgress& progress);

  /// Whether the last one was saved.
  bool saved() const { return failure_.empty(); }

private:
  std::string path_;
  std::string failure_;
};

}  // namespace ratchet_sieve
