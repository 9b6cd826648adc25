#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/sweep/case_file.h"

namespace ratchet_sieve
{

// Files exchanged by a coordinator and its jobs: a line of JSON with the file's type and version, and a line
// per case or result.

/// Limits of a file's content, because it may come from any source.
constexpr std::size_t LARGEST_FILE = std::size_t(1) << 28;  ///< [bytes]
constexpr int DEEPEST_JSON = 32;                            ///< nesting of maps and lists
constexpr std::size_t MOST_KEYS = 1000;                     ///< per map
constexpr std::size_t LONGEST_KEY = 100;                    ///< [bytes], without control characters

/// The lines after the first. @param kind of the file @throws CaseFileError
std::vector<nlohmann::ordered_json> readJsonLines(const std::string& path, const char* kind);

/// Writes such a file, completely or not at all. @throws OutputError
void writeJsonLines(const std::string& path, const char* kind,
                    const std::vector<nlohmann::ordered_json>& lines);

}  // namespace ratchet_sieve
