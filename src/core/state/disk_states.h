#pragma once

#include <functional>

#include "ratchet_sieve/core/observation.h"
#include "state/machine_state.h"

namespace ratchet_sieve
{

/// Shows `visit` each active disk as it is at a local time, one after another: a million at once would need
/// as much memory again as the engine.
void forEachDiskState(const MachineState& machine, double time,
                      const std::function<void(const DiskState&)>& visit);

}  // namespace ratchet_sieve
