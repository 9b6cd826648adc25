#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/analysis/run_analysis.h"

namespace ratchet_sieve
{

/// The result as a readable table: counts per bin and species, <V_x> with standard errors, Q, P, contacts.
std::string reportText(const RunResult& result);

/// The result as a JSON object, with the names of a run's summary for the same quantities.
nlohmann::ordered_json reportJson(const RunResult& result);

}  // namespace ratchet_sieve
