#pragma once

#include <string>
#include <vector>

namespace ratchet_sieve
{

/// Runs a script such as plot_analysis.py, which is in the same directory as this program. The script draws
/// the tables in a directory and prints the paths of its pictures.
/// @param arguments the directory first
/// @return its exit status: DONE, or FAILED or REFUSED after it has printed an error line
/// @throws std::runtime_error if it cannot be run
int plotTables(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace ratchet_sieve
