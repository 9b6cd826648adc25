#pragma once

#include <optional>

#include "search/contact_search.h"
#include "simd/simd_batch.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// The constants for the SIMD kernels; nothing if the plan has no SIMD, or while the base moves to a
/// setpoint.
std::optional<BatchScene> batchScene(const SystemState& system);

/// Copies a disk and its next event into a row.
void loadRow(const SystemState& system, std::uint32_t slot, const BaseEvent& next, SimdBatch& batch,
             std::size_t row);

/// Copies the flight of a row's disk.
void readState(const SimdBatch& batch, std::size_t row, Disk& disk);

/// Copies a row's disk and its next event back.
void storeRow(const SimdBatch& batch, std::size_t row, SystemState& system, std::uint32_t slot,
              BaseEvent& next);

/// Moves a row before its next event is executed.
void copyRow(SimdBatch& batch, std::size_t from, std::size_t to);

/// A row's next event.
BaseEvent rowEvent(const SimdBatch& batch, std::size_t row);

/// The outcome of a row's event after `collide`. A row without a contact has a separating outcome.
inline ContactOutcome outcomeOf(const BatchScene& scene, const SimdBatch& batch, std::size_t row,
                                std::uint32_t slot, std::uint32_t species)
{
  // Indexed by BatchFeature.
  constexpr CollisionKind KINDS[] = {CollisionKind::APEX, CollisionKind::RIGHT_SLOPE,
                                     CollisionKind::LEFT_SLOPE, CollisionKind::APEX};
  ContactOutcome outcome;
  outcome.time = batch.time[row];
  outcome.kind =
      scene.height > 0.0 ? KINDS[static_cast<std::int32_t>(batch.feature[row])] : CollisionKind::LEVEL;
  outcome.i = slot;
  outcome.species = species;
  outcome.normal = {batch.normal_x[row], batch.normal_y[row]};
  outcome.normal_velocity = batch.normal_velocity[row];
  outcome.normal_impulse = batch.normal_impulse[row];
  outcome.tangential_impulse = batch.tangential_impulse[row];
  outcome.overlap = batch.overlap[row];
  outcome.closed = batch.normal_velocity[row] < 0.0;
  return outcome;
}

}  // namespace ratchet_sieve
