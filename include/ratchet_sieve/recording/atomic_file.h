#pragma once

#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ratchet_sieve/recording/locked_file.h"

namespace ratchet_sieve
{

/// A file that cannot be written. The message names it and the reason.
struct OutputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// @throws OutputError
[[noreturn]] void failToWrite(const std::string& path, const std::string& reason);

/// Makes a folder, and those that it is in. @throws OutputError
void makeFolder(const std::string& path);

/// The path that a symbolic link names, which need not exist; any other path as it is.
std::string linkTarget(const std::string& path);

/// A file that is written completely or not at all: into a part beside it, FILE.sieve_part, which commit()
/// renames. A symbolic link stays, and the file that it names is written. Anything that is not a regular file
/// (a device, a pipe) is written directly. A pipe is opened once, so that its reader sees one end.
class AtomicFile
{
public:
  /// Opens the file. Not explicit: a path is an output. @throws OutputError if it cannot be opened
  AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// Closes the file. @throws OutputError if it could not be written completely
  void finish();

  /// Closes the file, and renames the temporary file. @throws OutputError if the file could not be written
  /// completely
  void commit();

private:
  void openPart();
  void discard();

  std::string path_;
  std::string written_path_;
  std::unique_ptr<LockedFile> file_;  ///< null once committed
  std::ofstream stream_;
};

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
