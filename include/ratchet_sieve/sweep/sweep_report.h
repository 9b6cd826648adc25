#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/sweep/best_setting.h"
#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

/// The progress of a sweep according to its results file, in a few lines: completed cases of its present
/// plan, warnings, the best setting, errors. @throws DatabaseError
std::string statusText(const Sweep& sweep, const std::string& results, const BestCriteria& criteria = {});

/// The text of a report, beside its table and pictures.
struct SweepFindings
{
  BestCriteria criteria;
  std::optional<SettingMean> best;
  std::uint64_t warned = 0;        ///< cases with a warning
  std::vector<std::string> lines;  ///< the best setting, warnings
};

/// @throws DatabaseError
SweepFindings findingsOf(const Sweep& sweep, const std::string& results, const BestCriteria& criteria);

/// Input of the report's plotting script: `lines`, `best` with its values of the swept keys, and the
/// criteria.
nlohmann::ordered_json findingsJson(const Sweep& sweep, const SweepFindings& findings);

/// The command line of sieve_run for the sweep's scene and what is set in every case. A case's own arguments
/// follow it, see exportCsv(). @param scene path of the scene's file
std::string commandText(const Sweep& sweep, const std::string& scene);

/// Writes the results of a sweep's cases as CSV (RFC 4180), in the order of the sweep: swept keys, seed,
/// status, error, the scalars of the summaries, the case's arguments of sieve_run, hashes, version, wall time
/// and host. Numbers are read back bit for bit; undefined values are empty. @return number of rows
/// @throws DatabaseError
std::uint64_t exportCsv(const Sweep& sweep, const std::string& results, std::ostream& out);

/// Writes a line for each case: its number, its assignments, and whether it has a result. Checks that each is
/// legal.
/// @throws SceneError for the first illegal case
void listCases(const Sweep& sweep, const std::string& results, std::ostream& out);

}  // namespace ratchet_sieve
