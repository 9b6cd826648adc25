#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/json.h"

namespace ratchet_sieve
{

/// The run as a JSON object: scene_hash, seed, version, plan, times, counts, means, s, Q and P, their errors,
/// energies, overlaps, warnings. SI units; undefined values are null.
nlohmann::ordered_json summarize(const Simulation& simulation, const RunOutcome& outcome);

/// The computed parts of the model: each part of the plan by its name, true or false.
nlohmann::ordered_json planParts(const Plan& plan);

/// Adds `collisions` of each kind, `short_to_long` and, of a profile, `contacts_by_face`: lists `faces` and
/// `corners`.
void addContacts(nlohmann::ordered_json& json, const SceneDefinition& scene,
                 const CollisionCounts& collisions, const FaceContacts& contacts);

/// Adds the means of a species, each under the name of its field, without replacing existing keys.
void addMeans(nlohmann::ordered_json& species, const SpeciesMeans& means);

/// Adds `quality`, `separation` and `separation_by_mass`, of the best pair of species, `processed`, and
/// `purity` and `recovery`: of each bin, of each species, by number and by mass.
void addBinResults(nlohmann::ordered_json& json, const std::vector<std::string>& species,
                   const std::vector<SpeciesBins>& bins);

/// Adds what was observed, each under its name: of each bin, or of the whole machine, of each species its
/// numbers and its `table`.
void addObserved(nlohmann::ordered_json& json, const std::vector<Observed>& all);

}  // namespace ratchet_sieve
