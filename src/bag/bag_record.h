#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

/// The records of a bag (format 2.0, wiki.ros.org/Bags/Format/2.0). All lengths in the file are checked.
/// Integers are little-endian, as on the supported machines.
namespace ratchet_sieve
{

constexpr std::string_view VERSION_LINE = "#ROSBAG V2.0\n";  ///< a bag's first line
constexpr std::uint32_t INDEX_VERSION = 1;
constexpr std::uint32_t CHUNK_INFO_VERSION = 1;

/// An error in a bag's bytes.
struct DamagedBag : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The type of a record.
enum class BagOp : std::uint8_t
{
  MESSAGE = 2,
  FILE_HEADER = 3,
  INDEX = 4,
  CHUNK = 5,
  CHUNK_INFO = 6,
  CONNECTION = 7
};

/// The named fields of a record's header, as views into the bag's bytes.
class BagFields
{
public:
  /// @throws DamagedBag if a field extends beyond the header, has no name, or occurs twice
  explicit BagFields(std::string_view header);

  /// @throws DamagedBag if there is none of this name
  std::string_view text(const std::string& name) const;
  /// @throws DamagedBag if there is none of this name and size
  std::uint32_t number(const std::string& name) const { return value<std::uint32_t>(name); }
  std::uint64_t position(const std::string& name) const { return value<std::uint64_t>(name); }
  BagOp op() const { return static_cast<BagOp>(value<std::uint8_t>("op")); }
  bool has(const std::string& name) const { return values_.count(name) != 0; }

private:
  template <typename T>
  T value(const std::string& name) const
  {
    const std::string_view bytes = text(name);
    T value;
    if (bytes.size() != sizeof value)
      throw DamagedBag("the field " + name + " has " + std::to_string(bytes.size()) + " bytes, not " +
                       std::to_string(sizeof value));
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }

  std::map<std::string_view, std::string_view> values_;
};

struct BagRecord
{
  BagFields fields;
  std::string_view bytes;

  /// @throws DamagedBag if it is another
  void requireOp(BagOp op) const;
};

/// A reader for the bytes of a bag or a chunk, which never reads beyond their end.
class BagBytes
{
public:
  explicit BagBytes(std::string_view bytes) : bytes_(bytes) {}

  std::size_t position() const { return position_; }
  std::size_t size() const { return bytes_.size(); }
  bool atEnd() const { return position_ == bytes_.size(); }

  /// All throw DamagedBag if fewer bytes are left.
  std::string_view take(std::size_t count);
  std::uint32_t takeNumber();
  std::string_view takeSized();  ///< a length of 32 bits, and this many bytes
  BagRecord takeRecord();

private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

}  // namespace ratchet_sieve
