#pragma once

#include <csignal>

#include <sys/resource.h>

namespace ratchet_sieve
{

/// Limits the file size of this program and of programs started during its lifetime: equivalent to a full
/// disk.
class FileSizeLimit
{
public:
  /// @param bytes of the largest file
  explicit FileSizeLimit(rlim_t bytes) : before_handler_(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit()
  {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, before_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  rlimit before_{};
  void (*before_handler_)(int);
};

}  // namespace ratchet_sieve
