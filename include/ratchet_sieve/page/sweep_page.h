#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace ratchet_sieve
{

/// Writes the report of a sweep as one HTML file that needs nothing else. @param report its report.json, see
/// docs/sweeps.md @throws OutputError
void writeSweepPage(const std::string& path, const nlohmann::ordered_json& report);

}  // namespace ratchet_sieve
