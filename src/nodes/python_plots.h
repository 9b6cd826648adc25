#pragma once

#include <string>
#include <vector>

namespace ratchet_sieve
{

/// Runs a program of the Python package, such as ratchet_sieve.plots.analysis. It draws the tables in a
/// directory and prints the paths of its pictures.
/// @param arguments the directory first
/// @return its exit status: DONE, or FAILED or REFUSED after it has printed an error line
/// @throws std::runtime_error if it cannot be run
int plotTables(const std::string& module, const std::vector<std::string>& arguments);

}  // namespace ratchet_sieve
