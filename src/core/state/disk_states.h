#pragma once

#include <functional>

#include "ratchet_sieve/core/observation.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Calls `visit` with the state of each active disk at a local time, one after the other, because an array of
/// all states would need as much memory as the engine itself.
void forEachDiskState(const SystemState& system, double time,
                      const std::function<void(const DiskState&)>& visit);

}  // namespace ratchet_sieve
