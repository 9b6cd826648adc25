#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_result.h"

namespace ratchet_sieve
{

/// A file that is not a case or result file, or is damaged, or is of another version of the program.
struct CaseFileError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Writes cases with their complete scenes to a file, which another machine can run without the sweep file.
/// @throws OutputError
void writeCaseFile(const std::string& path, const std::vector<SweepCase>& cases);

/// Runs the cases of a case file one after the other, and writes all results to a file beside it, completely
/// or not at all. Does nothing if the results already exist.
/// @return whether all cases were run @throws CaseFileError, OutputError
bool runCaseFile(const std::string& path, const std::function<bool()>& stop_wanted);

/// The result file of runCaseFile().
std::string resultPath(const std::string& case_path);

/// The results in a result file, without `scene_hash`, `seed` and `values`. @throws CaseFileError
std::vector<CaseResult> readResultFile(const std::string& path);

}  // namespace ratchet_sieve
