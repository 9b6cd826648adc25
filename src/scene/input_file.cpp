#include "ratchet_sieve/scene/input_file.h"

#include <cerrno>
#include <cstring>

#include <sys/stat.h>
#include <unistd.h>

namespace ratchet_sieve
{

std::optional<std::string> whyUnreadable(const std::string& path)
{
  struct stat status;
  // Not opened: that would disturb the writer of a named pipe.
  if (stat(path.c_str(), &status) != 0)
    return errno == ENOENT || errno == ENOTDIR ? "no such file" : std::strerror(errno);
  if (S_ISDIR(status.st_mode))
    return "is a directory";
  if (access(path.c_str(), R_OK) != 0)
    return std::strerror(errno);
  return std::nullopt;
}

}  // namespace ratchet_sieve
