#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace ratchet_sieve
{

/// An output that is an input or another output. The message names both arguments.
struct SameFileError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file that a program reads or writes. An empty path is no file.
struct NamedFile
{
  std::string name;  ///< of the argument that gives its path, such as --summary
  std::string path;
};

/// Checks that no output is an input or another output, also by a link, before anything is written. Devices
/// and pipes may be named more than once.
/// @throws SameFileError
void requireDistinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// The files of a folder that a program would write over `files`, if these lie in it.
/// @param written the endings of what is written there: ".csv", or "/report.json" for one name
std::vector<NamedFile> outputsInFolder(const NamedFile& folder, const std::vector<NamedFile>& files,
                                       const std::vector<std::string>& written);

}  // namespace ratchet_sieve
