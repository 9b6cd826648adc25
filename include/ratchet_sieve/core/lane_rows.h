#pragma once

#include <optional>

#include "ratchet_sieve/core/contact_search.h"
#include "ratchet_sieve/core/lane_batch.h"
#include "ratchet_sieve/core/machine.h"

namespace ratchet_sieve
{

/// What the lanes need to know of a machine; nothing where its plan has none, and while its base is on the
/// way to a setpoint.
std::optional<LaneScene> laneScene(const Machine& machine);

/// Puts a disk and its next event into a row.
void loadRow(const Machine& machine, std::uint32_t id, const BaseEvent& next, LaneBatch& batch,
             std::size_t row);

/// Puts a row's disk and its next event back.
void storeRow(const LaneBatch& batch, std::size_t row, Machine& machine, std::uint32_t id, BaseEvent& next);

void copyRow(LaneBatch& batch, std::size_t from, std::size_t to);

/// A row's next event.
BaseEvent rowEvent(const LaneBatch& batch, std::size_t row);

}  // namespace ratchet_sieve
