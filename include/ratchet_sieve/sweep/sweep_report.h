#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/sweep/sweep.h"
#include "ratchet_sieve/sweep/sweep_results.h"

namespace ratchet_sieve
{

/// One line: done, running, failed, with warnings, rate, time left.
std::string sweepProgressText(const SweepProgress& progress);

/// The estimated processor time of all cases, then a line for each corner of the grid, where the keys have
/// their first or last values. From a run of at most half a second of each corner, of at most 16: from the
/// fifth axis on, axes go to their ends together with an earlier one.
/// @throws SceneError for an illegal case
std::vector<std::string> costLines(const Sweep& sweep);

/// The progress of a sweep according to its results file, in a few lines: completed cases of its present
/// plan, warnings, errors. @throws DatabaseError
std::string statusText(const Sweep& sweep, const std::string& results);

/// What a report needs besides the table of exportCsv(): `command`, the command line of sieve_run for the
/// scene and what is set in every case, which a case's own arguments follow; the number of `seeds` of a
/// setting; lines on `warnings`. @param scene path of the scene's file @throws DatabaseError
nlohmann::ordered_json reportBasis(const Sweep& sweep, const std::string& results, const std::string& scene);

/// Writes the results of a sweep's cases as CSV (RFC 4180), in the order of the sweep: swept keys, seed,
/// status, error, the scalars of the summaries, the case's arguments of sieve_run, hashes, version, wall time
/// and host. Numbers are read back bit for bit; undefined values are empty. @throws DatabaseError
void exportCsv(const Sweep& sweep, const std::string& results, std::ostream& out);

/// Writes a line for each case: its number, its assignments, and whether it has a result.
void listCases(const Sweep& sweep, const LegalCases& cases, const std::string& results, std::ostream& out);

}  // namespace ratchet_sieve
