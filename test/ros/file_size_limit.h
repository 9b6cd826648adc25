#pragma once

#include <csignal>

#include <sys/resource.h>

namespace ratchet_sieve
{

/// No file of this program, and of those it starts meanwhile, can grow beyond a size while this lives:
/// as good as a full disk, and to be had without a disk.
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
