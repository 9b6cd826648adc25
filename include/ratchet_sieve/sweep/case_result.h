#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace ratchet_sieve
{

/// What became of one case.
struct CaseResult
{
  std::string run_hash;    ///< runHash() of its scene
  std::string scene_hash;  ///< sceneHash() of it
  std::uint64_t seed = 0;
  std::vector<std::optional<std::string>> values;  ///< of the swept keys, YAML text
  std::string error;                               ///< why it failed; empty: it is done
  double wall_time = 0.0;                          ///< of the process that finished it [s]
  std::string host;
  nlohmann::ordered_json summary;  ///< summarize(); null where the run came to none
};

/// A column for each scalar of a summary: its key, `collisions.apex` for one within another,
/// `base_impulse.x`, and for a species `mean_vx.A`. Without those that the table has for every case, and
/// without its texts. Of more than MOST_COLUMN_SPECIES species, and of those whose names differ in their case
/// alone, there are none.
std::vector<std::pair<std::string, nlohmann::ordered_json>> summaryColumns(
    const nlohmann::ordered_json& summary);

constexpr std::size_t MOST_COLUMN_SPECIES = 32;

}  // namespace ratchet_sieve
