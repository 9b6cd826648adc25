#pragma once

#include <vector>

#include "observe/bins.h"
#include "observe/flow_blocks.h"
#include "observe/observable.h"

namespace ratchet_sieve
{

class FaceCounts;

/// The observers of every run, and those that its scene asks for. The EventLog has them; this reads them.
class RunObservers
{
public:
  /// @param system outlives this
  explicit RunObservers(SystemState& system);

  const Bins& bins() const { return *bins_; }
  const RecentExits& exits() const { return *exits_; }
  RecentExits& exits() { return *exits_; }

  /// See FlowBlocks::series().
  FlowSeries flowSeries(double start, double block_time) const
  {
    return flow_ != nullptr ? flow_->series(start, block_time) : FlowSeries();
  }

  /// Of a profile; empty for a sawtooth.
  FaceContacts faceContacts() const;

  /// What the scene asks for, until `time`; before the end of `settle` as if nothing had happened yet.
  std::vector<Observed> observed(double time, bool settled) const;

private:
  const SystemState& system_;
  Bins* bins_;
  RecentExits* exits_;
  const FlowBlocks* flow_ = nullptr;            ///< where disks are fed and can leave
  std::vector<const Observable*> observables_;  ///< in the order of the scene
  const FaceCounts* faces_ = nullptr;           ///< of a profile
};

}  // namespace ratchet_sieve
