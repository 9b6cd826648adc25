#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/live/live_run.h"

namespace ratchet_sieve
{

/// Reports the progress of a run at every tenth of its duration.
class ProgressLog
{
public:
  /// @return a line for the log if another tenth was reached
  std::optional<std::string> line(const LiveRun& run);

private:
  int tenths_ = 0;  ///< that were announced
};

}  // namespace ratchet_sieve
