#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/headless_run.h"

namespace ratchet_sieve
{

/// The run in one JSON object: scene_hash, seed, version, plan, times, counts, means, Q and P, how sure they
/// are, energies, overlaps, warnings. SI units; what is not defined is null.
nlohmann::ordered_json summarize(const Simulation& simulation, const RunOutcome& outcome);

/// What of the model is worked out: each part of the plan by its name, true or false.
nlohmann::ordered_json planParts(const Plan& plan);

/// Collisions of each kind: disk_disk, left_slope, right_slope, apex, wall.
nlohmann::ordered_json collisionCounts(const CollisionCounts& counts);

/// Adds the means of a species, each under the name of its field, but for those that are there.
void addMeans(nlohmann::ordered_json& species, const SpeciesMeans& means);

/// A number, or null where there is none.
nlohmann::ordered_json numberOrNull(const std::optional<double>& value);

}  // namespace ratchet_sieve
