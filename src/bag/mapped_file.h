#pragma once

#include <string>
#include <string_view>

namespace ratchet_sieve
{

/// A file mapped into memory for reading.
class MappedFile
{
public:
  /// @throws BagError if there is no such file, or it cannot be read
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }

private:
  std::string_view bytes_;
};

}  // namespace ratchet_sieve
