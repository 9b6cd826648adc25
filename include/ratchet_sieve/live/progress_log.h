#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/live/live_run.h"

namespace ratchet_sieve
{

/// Says how far a run is between its start and its end, at every tenth of it.
class ProgressLog
{
public:
  /// @return a line for the log; nothing where the run has not come to another tenth
  std::optional<std::string> line(const LiveRun& run);

private:
  int tenths_ = 0;  ///< that were announced
};

}  // namespace ratchet_sieve
