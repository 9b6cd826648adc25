#include "mapped_file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ratchet_sieve/bag/bag_error.h"
#include "ratchet_sieve/scene/input_file.h"

namespace ratchet_sieve
{
namespace
{

/// Closes a file descriptor at the end of its life.
struct OpenFile
{
  explicit OpenFile(const std::string& path) : descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~OpenFile()
  {
    if (descriptor >= 0)
      close(descriptor);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor;
};

[[noreturn]] void fail(const std::string& path, const char* reason)
{
  throw BagError(path + ": cannot be read as a bag: " + reason);
}

}  // namespace

MappedFile::MappedFile(const std::string& path)
{
  if (const auto why = whyUnreadable(path))
    throw BagError(path + ": " + *why);
  const OpenFile file(path);
  struct stat status;
  if (file.descriptor < 0 || fstat(file.descriptor, &status) != 0)
    fail(path, std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    fail(path, "is not a file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0)
    return;
  void* place = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.descriptor, 0);
  if (place == MAP_FAILED)
    fail(path, std::strerror(errno));
  bytes_ = {static_cast<const char*>(place), size};
}

MappedFile::~MappedFile()
{
  if (!bytes_.empty())
    munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

}  // namespace ratchet_sieve
