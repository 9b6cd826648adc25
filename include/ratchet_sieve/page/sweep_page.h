#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace ratchet_sieve
{

/// Writes the report of a sweep as one HTML file that needs nothing else. @param report its report.json, as
/// python/ratchet_sieve/plots/sweep_page.py describes it @throws OutputError
void writeSweepPage(const std::string& path, const nlohmann::ordered_json& report);

}  // namespace ratchet_sieve
