#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/analysis/run_analysis.h"

/// The parts of a run's page, as its script reads them. SI units; undefined values are null.
namespace ratchet_sieve
{

/// What the motion of the base and the outline of the machine follow from.
nlohmann::ordered_json machinePart(const SceneDefinition& scene);

/// Columns over time: `drive`, `bins`, `velocities`. Rows between which nothing changes are left out.
nlohmann::ordered_json seriesPart(const RunResult& result);

/// Each command as its time and a text.
nlohmann::ordered_json commandsPart(const std::vector<CommandFrame>& commands, const SceneDefinition& scene);

}  // namespace ratchet_sieve
