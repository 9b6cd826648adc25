#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

namespace ratchet_sieve
{

/// A file that cannot be written; names it and says why.
struct OutputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file that appears whole or not at all: written beside its place under a name of its own, and
/// moved there by commit(). What is no regular file (a device, a pipe) is written to directly.
class AtomicFile
{
public:
  /// Opens it. @throws OutputError where that is not allowed
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// Puts it in its place. @throws OutputError if it could not be written in full
  void commit();

private:
  std::string path_;
  std::string written_path_;
  std::ofstream stream_;
  bool committed_ = false;
};

}  // namespace ratchet_sieve
