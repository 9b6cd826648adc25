#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/analysis/run_analysis.h"

namespace ratchet_sieve
{

/// Writes a run's result as CSV into a directory, which it makes where it is not there. SI units;
/// what is not defined is an empty field.
///   bins.csv           time,species,left,right,on_base
///   segregation.csv    time,quality,processed
///   drive.csv          time, then inclination, frequency and amplitude, each applied and commanded
///   statistics.csv     time,species,mean_vx,mean_vx_stderr,granular_temperature
///   contacts.csv       time, counts of each kind since the start, short_to_long, collision_rate
///   velocities.csv     species,disks,mean_vx,mean_vx_stderr
///   displacements.csv  time,species,from,to,count,density
/// @return the paths written
/// @throws OutputError
std::vector<std::string> writeTables(const RunResult& result, const std::string& directory);

}  // namespace ratchet_sieve
