#pragma once

#include "ratchet_sieve/ros/live_run.h"

namespace ratchet_sieve
{

/// Says in the log how far a run is, at every tenth of it.
class ProgressLog
{
public:
  void update(const LiveRun& run);

private:
  int tenths_ = 0;  ///< that were announced
};

}  // namespace ratchet_sieve
