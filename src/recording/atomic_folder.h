#pragma once

#include <filesystem>
#include <string>

namespace ratchet_sieve
{

/// A folder of files of one ending that is written completely or not at all: as a temporary folder beside it,
/// which commit() renames. It replaces an earlier folder of such files, and no other.
class AtomicFolder
{
public:
  /// @param ending of every file, with its dot
  /// @throws OutputError if it cannot be made, or if there is anything of this name that has other contents
  AtomicFolder(const std::string& path, const std::string& ending);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  /// Writes a file. After an error, which finish() throws, later files are not written.
  /// @param name without the ending
  void write(const std::string& name, const std::string& contents);

  /// @throws OutputError if a file could not be written completely
  void finish() const;

  /// Replaces the earlier folder. @throws OutputError as finish(), or if it cannot be replaced
  void commit();

private:
  void requireReplaceable() const;

  std::filesystem::path path_;
  std::filesystem::path written_path_;
  std::string ending_;
  std::string failure_;
  bool committed_ = false;
};

}  // namespace ratchet_sieve
