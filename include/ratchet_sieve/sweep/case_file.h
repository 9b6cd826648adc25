#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_result.h"

namespace ratchet_sieve
{

/// A file of cases or of results that is none, is damaged, or is of another version of the program.
struct CaseFileError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Writes cases into a file that another machine can run without the sweep: their whole scenes. @throws
/// OutputError
void writeCaseFile(const std::string& path, const std::vector<SweepCase>& cases);

/// Runs the cases of such a file one after the other, and writes what came of them beside it, whole or not at
/// all. Does nothing where the results are there already.
/// @return whether it came to its end @throws CaseFileError, OutputError
bool runCaseFile(const std::string& path, const std::function<bool()>& stop_wanted);

/// Where runCaseFile() writes.
std::string resultPath(const std::string& case_path);

/// @throws CaseFileError
std::vector<CaseResult> readResultFile(const std::string& path);

}  // namespace ratchet_sieve
