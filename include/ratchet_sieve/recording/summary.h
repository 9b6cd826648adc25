#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/headless_run.h"

namespace ratchet_sieve
{

/// The run as a JSON object: scene_hash, seed, version, plan, times, counts, means, s, Q and P, their errors,
/// energies, overlaps, warnings. SI units; undefined values are null.
nlohmann::ordered_json summarize(const Simulation& simulation, const RunOutcome& outcome);

/// The computed parts of the model: each part of the plan by its name, true or false.
nlohmann::ordered_json planParts(const Plan& plan);

/// Collisions of each kind: disk_disk, left_slope, right_slope, apex, wall, level.
nlohmann::ordered_json collisionCounts(const CollisionCounts& counts);

/// Contacts with each part of a profile: lists `faces` and `corners`.
nlohmann::ordered_json contactsByFace(const FaceContacts& contacts);

/// Adds the means of a species, each under the name of its field, without replacing existing keys.
void addMeans(nlohmann::ordered_json& species, const SpeciesMeans& means);

/// Adds `quality`, `separation` and `separation_by_mass`, of the best pair of species.
void addSeparation(nlohmann::ordered_json& json, const std::vector<SpeciesBins>& bins);

/// Adds `purity` and `recovery`: of each bin, of each species, by number and by mass.
void addBinShares(nlohmann::ordered_json& json, const std::vector<std::string>& species,
                  const std::vector<SpeciesBins>& bins);

/// What was observed: of each bin, or of the whole machine, of each species its numbers and its `table`.
nlohmann::ordered_json observedResults(const Observed& observed);

/// A number, or null where there is none.
nlohmann::ordered_json numberOrNull(const std::optional<double>& value);

}  // namespace ratchet_sieve
