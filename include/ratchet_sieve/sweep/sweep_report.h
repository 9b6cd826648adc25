#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

/// How far a sweep is, by its results file alone, in a few lines. @throws DatabaseError
std::string statusText(const Sweep& sweep, const std::string& results);

/// The results of a sweep's cases as CSV (RFC 4180), in the order of the sweep: swept keys, seed, status,
/// error, what the summaries have as scalars, hashes, version, wall time and host. Numbers read back bit for
/// bit; what is not defined is empty. @return how many rows @throws DatabaseError
std::uint64_t exportCsv(const Sweep& sweep, const std::string& results, std::ostream& out);

/// A line for each case: its number, what it sets, and whether there is a result of it. Each is seen to be
/// legal.
/// @throws SceneError that names the first that is not
void listCases(const Sweep& sweep, const std::string& results, std::ostream& out);

/// How long all cases would take, by the first of them, of which a second at most is run: `about 3 days`, or
/// why that is unknown.
std::string estimateText(const Sweep& sweep, std::size_t threads);

}  // namespace ratchet_sieve
