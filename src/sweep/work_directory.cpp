#include "ratchet_sieve/sweep/work_directory.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/sweep/database.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* LOCK = "/lock";

/// Of a whole file. Locks of open descriptions belong to no process: two in one process exclude each other as
/// well.
struct flock lockOf(short type)
{
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Whether the descriptor still is the file at the path: the last process may have removed it meanwhile.
bool isThere(const std::string& path, int descriptor)
{
  struct stat named;
  struct stat opened;
  return stat(path.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino;
}

}  // namespace

std::string workDirectory(const std::string& results)
{
  return linkTarget(results) + ".d";
}

const std::string& checkpointEnding()
{
  static const std::string ENDING = ".physics" + std::to_string(PHYSICS_VERSION) + ".checkpoint";
  return ENDING;
}

std::string checkpointPath(const std::string& results, const std::string& run_hash)
{
  return workDirectory(results) + '/' + run_hash + checkpointEnding();
}

ResultsLock::ResultsLock(const std::string& results) : directory_(workDirectory(results))
{
  const std::string path = directory_ + LOCK;
  do
  {
    if (descriptor_ >= 0)
      close(descriptor_);
    std::error_code ignored;  // an open file says why
    std::filesystem::create_directories(directory_, ignored);
    descriptor_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    struct flock lock = lockOf(F_WRLCK);
    if (descriptor_ >= 0 && fcntl(descriptor_, F_OFD_SETLK, &lock) == 0)
      continue;
    const int reason = errno;
    if (descriptor_ >= 0)
      close(descriptor_);
    if (reason == EAGAIN)
      throw DatabaseError(results + ": another process runs a sweep into this file");
    throw DatabaseError(path + ": cannot be locked: " + std::strerror(reason));
  } while (!isThere(path, descriptor_));
}

ResultsLock::~ResultsLock()
{
  unlink((directory_ + LOCK).c_str());
  close(descriptor_);
  rmdir(directory_.c_str());
}

bool ResultsLock::isHeld(const std::string& results)
{
  const int descriptor = open((workDirectory(results) + LOCK).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  struct flock lock = lockOf(F_RDLCK);
  const bool is_held = fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  close(descriptor);
  return is_held;
}

}  // namespace ratchet_sieve
