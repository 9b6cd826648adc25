#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

namespace ratchet_sieve
{

/// A file that cannot be written. The message names it and the reason.
struct OutputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// @throws OutputError
[[noreturn]] void failToWrite(const std::string& path, const std::string& reason);

/// The path that a symbolic link names, which need not exist; any other path as it is.
std::string linkTarget(const std::string& path);

/// A file that is written completely or not at all: into a temporary file in the same directory, which
/// commit() renames. A symbolic link stays, and the file that it names is written. Anything that is not a
/// regular file (a device, a pipe) is written directly.
class AtomicFile
{
public:
  /// Opens the file. @throws OutputError if it cannot be opened
  explicit AtomicFile(const std::string& path);
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
  std::string path_;
  std::string written_path_;
  std::ofstream stream_;
  bool committed_ = false;
};

}  // namespace ratchet_sieve
