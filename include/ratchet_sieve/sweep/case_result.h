#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace ratchet_sieve
{

/// The swept keys of a case and their values as YAML text; nothing for a key that its scene does not have.
using CaseValues = std::vector<std::pair<std::string, std::optional<std::string>>>;

/// The result of one case.
struct CaseResult
{
  std::string run_hash;    ///< runHash() of its scene
  std::string scene_hash;  ///< sceneHash() of it
  std::uint64_t seed = 0;
  CaseValues values;
  std::string error;       ///< reason of a failure; empty on success
  double wall_time = 0.0;  ///< of the process that completed it [s]
  std::string host;
  nlohmann::ordered_json summary;  ///< summarize(); null on failure
};

/// One column for each scalar of a summary. Its name is the key; nested keys are joined, as in
/// `collisions.apex` or `base_impulse.x`; values of a species have its name, as in `mean_vx.A`, and of
/// a size class its number as well, as in `size_classes.1.left.A`. In addition
/// `counted`, the number of disks that left; `warnings`, their number, and `warning_text`. Not included:
/// columns that the table has for every case, other texts, and species columns if there are more than
/// MOST_COLUMN_SPECIES species. If names differ only in case, all but the first in byte order get a number:
/// `mean_vx.a (2)`.
using SummaryColumns = std::vector<std::pair<std::string, nlohmann::ordered_json>>;
SummaryColumns summaryColumns(const nlohmann::ordered_json& summary);

constexpr std::size_t MOST_COLUMN_SPECIES = 32;

}  // namespace ratchet_sieve
