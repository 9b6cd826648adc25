#pragma once

#include <string>

namespace ratchet_sieve
{

/// Runs plot_analysis.py, which stands beside this program wherever that is built or installed: it
/// draws the tables in a directory and prints the paths of its pictures.
/// @throws std::runtime_error if it is not there, or fails
void plotTables(const std::string& directory);

}  // namespace ratchet_sieve
