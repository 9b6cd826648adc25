#pragma once

#include <string>

#include <sys/types.h>

namespace ratchet_sieve
{

/// A file that is opened for writing, and made if there is none. A regular file is locked as long as this
/// exists; the kernel ends the lock with the program. The lock is the file's, by whichever name it is opened.
/// It excludes others within this process as well. File systems without locks grant it.
class LockedFile
{
public:
  /// Waits for the reader of a pipe; a signal that is handled ends that.
  /// @param byte that is locked: 0 of a file that takes shape under its own name, others are not isLocked()
  explicit LockedFile(const std::string& path, off_t byte = 0);
  ~LockedFile();
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  /// 0; EAGAIN: another one has locked it; or the system's error.
  int error() const { return error_; }
  int descriptor() const { return descriptor_; }

  /// Whether any program, also this one, writes such a file. @pre it is no pipe
  static bool isLocked(const std::string& path);

private:
  void close();

  off_t byte_;
  int descriptor_ = -1;
  int error_ = 0;
};

}  // namespace ratchet_sieve
