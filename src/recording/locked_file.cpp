#include "ratchet_sieve/recording/locked_file.h"

#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ratchet_sieve
{
namespace
{

constexpr useconds_t READER_PERIOD = 50'000;  ///< between looks for the reader of a pipe [us]

/// Of a descriptor, not of its process: two in one process exclude each other as well.
struct flock lockOf(off_t byte, short type)
{
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

/// open() itself would wait for the reader of a pipe, and go on waiting after a signal.
int openForWriting(const std::string& path)
{
  int descriptor = -1;
  do
    descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0666);
  while (descriptor < 0 && errno == ENXIO && std::filesystem::is_fifo(path) && usleep(READER_PERIOD) == 0);
  return descriptor;
}

/// Whether the path still names the file: whoever had locked it may have renamed or removed it.
bool isNamed(const std::string& path, const struct stat& opened)
{
  struct stat named
  {
  };
  return stat(path.c_str(), &named) == 0 && named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

}  // namespace

LockedFile::LockedFile(const std::string& path, off_t byte) : byte_(byte)
{
  struct stat opened
  {
  };
  do
  {
    close();
    descriptor_ = openForWriting(path);
    if (descriptor_ < 0 || fstat(descriptor_, &opened) != 0)
      error_ = errno;
    if (error_ != 0 || !S_ISREG(opened.st_mode))
      return;
    struct flock lock = lockOf(byte_, F_WRLCK);
    if (fcntl(descriptor_, F_OFD_SETLK, &lock) != 0 && errno == EAGAIN)
      error_ = EAGAIN;
  } while (error_ == 0 && !isNamed(path, opened));
}

LockedFile::~LockedFile()
{
  close();
}

/// A child of this process may have the descriptor as well.
void LockedFile::close()
{
  if (descriptor_ < 0)
    return;
  struct flock none = lockOf(byte_, F_UNLCK);
  fcntl(descriptor_, F_OFD_SETLK, &none);
  ::close(descriptor_);
  descriptor_ = -1;
}

bool LockedFile::isLocked(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  struct flock lock = lockOf(0, F_WRLCK);
  const bool is_locked = fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  ::close(descriptor);
  return is_locked;
}

}  // namespace ratchet_sieve
