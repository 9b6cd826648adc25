#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/analysis/run_analysis.h"

namespace ratchet_sieve
{

/// The result as a readable table: counts per bin and species, <V_x> with standard errors, Q, P, contacts.
std::string reportText(const RunResult& result);

/// The result as a JSON object, with the names of a run's summary for the same quantities.
nlohmann::ordered_json reportJson(const RunResult& result);

/// Writes a run's result as CSV files into a directory, which is created if missing. SI units, given in the
/// column's name: "time [s]". An undefined value is an empty field.
///   run.csv            scene_hash, seed, version, open_ends (1 or 0), first and last time
///   bins.csv           per time and species: left, right, on_base, their masses
///   segregation.csv    per time: quality, processed
///   drive.csv          per time: inclination, frequency and amplitude, each applied and commanded
///   statistics.csv     per time and species: all of SpeciesMeans, granular_temperature and its window
///   contacts.csv       per time: counts of each kind since the start, short_to_long, rates and their window
///   velocities.csv     per species: disks, mean_vx, its error
///   drift.csv          per time and species: disks in the machine, their mean displacement
///   displacements.csv  per time, species and range of displacements: count, density
///   observed.csv       per observable, place and species: each of its numbers; if there is any
///   NAME.csv           per place and species: the table of the observable NAME; of size_classes where
///                      species have sizes
/// @return the paths written
/// @throws OutputError
std::vector<std::string> writeTables(const RunResult& result, const std::string& directory);

}  // namespace ratchet_sieve
