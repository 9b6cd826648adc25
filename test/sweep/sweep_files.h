#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/sweep/database.h"
#include "recording/small_scenes.h"

namespace ratchet_sieve
{

/// Few disks on open ends, for some milliseconds of wall time.
constexpr const char* SMALL_SCENE = R"(
scene:
  base: {teeth: 4, asymmetry: 0.1}
  boundary: open
  species:
    - {name: A, count: 6, radius: 0.001, mass: 0.010}
    - {name: B, count: 6, radius: 0.003, mass: 0.001}
  duration: 0.2
)";

/// Every row of `cases` by its run_hash, each column by its name, as text; without columns that differ
/// between runs.
inline std::map<std::string, std::map<std::string, std::string>> tableOf(const std::string& results)
{
  const Database database(results, Database::Access::READ);
  Statement select(database, "SELECT * FROM cases");
  std::map<std::string, std::map<std::string, std::string>> rows;
  while (select.step())
  {
    std::map<std::string, std::string> row;
    for (int k = 0; k < select.columns(); ++k)
      row[select.columnName(k)] = select.value(k).is_null() ? "NULL" : select.text(k);
    row.erase("wall_time");
    row.erase("host");
    nlohmann::ordered_json summary = nlohmann::ordered_json::parse(row["summary"]);
    if (summary.is_object())
      summary.erase("wall_time");
    row["summary"] = summary.dump();
    rows[row["run_hash"] + ' ' + row["physics"]] = row;
  }
  return rows;
}

inline std::string textOf(const std::string& results, const std::string& query)
{
  const Database database(results, Database::Access::READ);
  Statement select(database, query);
  return select.step() ? select.text(0) : "";
}

/// Writes a text to a file in a temporary directory.
inline std::string written(const ScratchDirectory& directory, const std::string& name,
                           const std::string& text)
{
  std::ofstream(directory / name) << text;
  return directory / name;
}

}  // namespace ratchet_sieve
