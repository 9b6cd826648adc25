#include "ratchet_sieve/recording/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

/// As many as the kernel follows.
constexpr int MOST_LINKS = 40;

/// Of the name of a part, before a number.
constexpr const char* PART = ".sieve_part";

/// Another than of a file that is written under its own name: while it gets its name, others may replace it.
constexpr off_t PART_BYTE = 1;

bool isWrittenDirectly(const std::string& path)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

fs::path placeOf(const std::string& path)
{
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(linkTarget(path), ignored), ignored);
}

bool isSameFile(const std::string& one, const std::string& other)
{
  std::error_code error;
  const bool same = fs::equivalent(one, other, error);
  return error ? placeOf(one) == placeOf(other) : same;
}

/// Whether it can be lost: a device or a pipe cannot.
bool isFile(const NamedFile& file)
{
  std::error_code ignored;
  return !file.path.empty() && !fs::is_other(file.path, ignored);
}

/// @throws OutputError if a program writes the file under its own name: it must not be replaced
void requireUnlocked(const std::string& path)
{
  if (LockedFile::isLocked(path))
    failToWrite(path, "another program is writing it");
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

void makeFolder(const std::string& path)
{
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw OutputError(path + ": cannot be made: " + error.message());
}

AtomicFile::AtomicFile(const std::string& path) : path_(path), written_path_(path)
{
  if (isWrittenDirectly(path))
    file_ = std::make_unique<LockedFile>(path);
  else
    openPart();
  errno = file_->error();
  if (errno == 0)
    stream_.open(written_path_, std::ios::binary | std::ios::trunc);
  if (stream_.is_open())
    return;
  const std::string reason = errno == EINTR ? "stopped while nobody read it" : std::strerror(errno);
  discard();
  failToWrite(path_, reason);
}

AtomicFile::~AtomicFile()
{
  discard();
}

/// A part that another program writes is left alone; one that a killed program has left is written anew.
void AtomicFile::openPart()
{
  path_ = linkTarget(path_);
  requireUnlocked(path_);
  for (int k = 1; !file_ || file_->error() == EAGAIN; ++k)
  {
    written_path_ = path_ + PART + (k > 1 ? std::to_string(k) : "");
    file_ = std::make_unique<LockedFile>(written_path_, PART_BYTE);
  }
}

void AtomicFile::discard()
{
  std::error_code ignored;
  if (file_ && file_->error() == 0 && written_path_ != path_)
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
    requireUnlocked(path_);
    std::error_code error;
    fs::rename(written_path_, path_, error);
    if (error)
      failToWrite(path_, error.message());
  }
  file_.reset();
}

void requireDistinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs)
{
  std::vector<NamedFile> others = inputs;
  for (const NamedFile& output : outputs)
  {
    for (const NamedFile& other : others)
      if (isFile(other) && isFile(output) && isSameFile(other.path, output.path))
        throw SameFileError(output.name + ' ' + output.path + ": is the file of " + other.name +
                            "; must be another one");
    others.push_back(output);
  }
}

std::vector<NamedFile> outputsInFolder(const NamedFile& folder, const std::vector<NamedFile>& files,
                                       const std::vector<std::string>& written)
{
  std::vector<NamedFile> outputs;
  for (const NamedFile& file : files)
  {
    const std::string name = '/' + fs::path(file.path).filename().string();
    const auto ends_so = [&name](const std::string& ending)
    {
      return name.size() >= ending.size() &&
             name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    };
    if (!folder.path.empty() && std::any_of(written.begin(), written.end(), ends_so))
      outputs.push_back({folder.name, folder.path + name});
  }
  return outputs;
}

}  // namespace ratchet_sieve
