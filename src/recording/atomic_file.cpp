#include "ratchet_sieve/recording/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

std::string writtenPath(const std::string& path)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return path;
  return path + ".part" + std::to_string(getpid());
}

}  // namespace

void failToWrite(const std::string& path, const std::string& reason)
{
  throw OutputError(path + ": cannot be written: " + reason);
}

AtomicFile::AtomicFile(const std::string& path) : path_(path), written_path_(writtenPath(path))
{
  errno = 0;
  stream_.open(written_path_, std::ios::binary | std::ios::trunc);
  if (!stream_)
    failToWrite(path_, std::strerror(errno));
}

AtomicFile::~AtomicFile()
{
  if (committed_ || written_path_ == path_)
    return;
  stream_.close();
  std::error_code ignored;
  fs::remove(written_path_, ignored);
}

void AtomicFile::finish()
{
  errno = 0;
  if (stream_.is_open())
    stream_.close();
  if (!stream_)
    failToWrite(path_, errno != 0 ? std::strerror(errno) : "it was not written completely");
}

void AtomicFile::commit()
{
  finish();
  if (written_path_ != path_)
  {
    std::error_code error;
    fs::rename(written_path_, path_, error);
    if (error)
      failToWrite(path_, error.message());
  }
  committed_ = true;
}

}  // namespace ratchet_sieve
