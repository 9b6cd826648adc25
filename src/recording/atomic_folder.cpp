#include "atomic_folder.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <unistd.h>

#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

}  // namespace

AtomicFolder::AtomicFolder(const std::string& path, const std::string& ending)
    : path_(linkTarget(path)),
      written_path_(path_.string() + ".part" + std::to_string(getpid())),
      ending_(ending)
{
  requireReplaceable();
  std::error_code error;
  fs::create_directory(written_path_, error);
  if (error)
    failToWrite(path_.string(), error.message());
}

AtomicFolder::~AtomicFolder()
{
  std::error_code ignored;
  if (!committed_)
    fs::remove_all(written_path_, ignored);
}

void AtomicFolder::requireReplaceable() const
{
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path_, error)))
    return;
  if (!fs::is_directory(path_, error))
    failToWrite(path_.string(), "it exists and is no folder");
  for (const fs::directory_entry& entry : fs::directory_iterator(path_, error))
    if (!entry.is_regular_file() || entry.path().extension() != ending_)
      failToWrite(path_.string(), "it has " + entry.path().filename().string() + ", and " + ending_ +
                                      " files alone are replaced");
  if (error)
    failToWrite(path_.string(), error.message());
}

void AtomicFolder::write(const std::string& name, const std::string& contents)
{
  if (!failure_.empty())
    return;
  errno = 0;
  std::ofstream file(written_path_ / (name + ending_), std::ios::binary | std::ios::trunc);
  file << contents;
  file.close();
  if (!file)
    failure_ = errno != 0 ? std::strerror(errno) : "it was not written completely";
}

void AtomicFolder::finish() const
{
  if (!failure_.empty())
    failToWrite(path_.string(), failure_);
}

void AtomicFolder::commit()
{
  finish();
  requireReplaceable();
  std::error_code error;
  fs::remove_all(path_, error);
  if (!error)
    fs::rename(written_path_, path_, error);
  if (error)
    failToWrite(path_.string(), error.message());
  committed_ = true;
}

}  // namespace ratchet_sieve
