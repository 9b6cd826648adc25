#pragma once

#include <string>
#include <vector>

namespace ratchet_sieve
{

/// Runs a script such as plot_analysis.py, which stands beside this program wherever that is built or
/// installed: it draws the tables in a directory and prints the paths of its pictures.
/// @param arguments its directory first
/// @return its exit status, 0 or REFUSED @throws std::runtime_error if it is not there, or fails
int plotTables(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace ratchet_sieve
