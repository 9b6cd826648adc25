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

/// As many as the kernel follows.
constexpr int MOST_LINKS = 40;

bool isWrittenDirectly(const std::string& path)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

std::string linkTarget(const std::string& path)
{
  std::error_code ignored;
  fs::path target = path;
  for (int links = 0; links < MOST_LINKS && fs::is_symlink(target, ignored); ++links)
    target = target.parent_path() / fs::read_symlink(target, ignored);
  return target.string();
}

void failToWrite(const std::string& path, const std::string& reason)
{
  throw OutputError(path + ": cannot be written: " + reason);
}

AtomicFile::AtomicFile(const std::string& path)
    : path_(isWrittenDirectly(path) ? path : linkTarget(path)),
      written_path_(isWrittenDirectly(path) ? path : path_ + ".part" + std::to_string(getpid()))
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
  const bool failed = !stream_;
  errno = 0;
  if (failed)  // once more, for the reason
  {
    stream_.clear();
    stream_.put('\n').flush();
  }
  if (stream_.is_open())
    stream_.close();
  if (!failed && stream_)
    return;
  stream_.setstate(std::ios::badbit);
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
