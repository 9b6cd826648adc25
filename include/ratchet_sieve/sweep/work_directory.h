#pragma once

#include <string>

namespace ratchet_sieve
{

/// The directory of checkpoints and of the lock, beside the results file.
std::string workDirectory(const std::string& results);

/// The checkpoint of a case, which holds for one physics version, as a result does; the names of all end with
/// checkpointEnding().
std::string checkpointPath(const std::string& results, const std::string& run_hash);
const std::string& checkpointEnding();

/// Held by the one process that writes a results file. The kernel releases it even if the process is killed.
class ResultsLock
{
public:
  /// Makes the work directory. @throws DatabaseError, also if another process holds the lock
  explicit ResultsLock(const std::string& results);

  /// Removes the work directory if nothing else is in it.
  ~ResultsLock();
  ResultsLock(const ResultsLock&) = delete;
  ResultsLock& operator=(const ResultsLock&) = delete;

  static bool isHeld(const std::string& results);

private:
  std::string directory_;
  int descriptor_ = -1;
};

}  // namespace ratchet_sieve
