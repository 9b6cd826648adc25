#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "bag_record.h"

namespace ratchet_sieve
{

/// One chunk of a bag: where its messages stand in it, and which of them the index has named.
class BagChunk
{
public:
  /// Unpacks the chunk and goes through all that is in it.
  /// @throws DamagedBag where it does not unpack to the size that it claims, or holds what is no message
  explicit BagChunk(const BagRecord& record);

  /// The size that a chunk claims to unpack to [bytes].
  static std::uint32_t claimedSize(const BagRecord& record) { return record.fields.number("size"); }

  /// Takes an index record of this chunk.
  /// @throws DamagedBag where it names what is no message of its connection, or one that was named before
  void takeIndex(const BagRecord& record);

  /// @throws DamagedBag if the index has not named every message
  void requireIndexed() const;

  std::size_t indexRecords() const { return index_records_; }

  /// When each message was recorded, in the order of the index [ns].
  const std::vector<std::uint64_t>& times() const { return times_; }

private:
  void readMessages(std::string_view unpacked);

  std::map<std::size_t, std::size_t> entries_;      ///< offsets that lead to a message, and its own offset
  std::map<std::size_t, std::uint32_t> unindexed_;  ///< messages not named yet, by offset: connection
  std::vector<std::uint64_t> times_;
  std::size_t index_records_ = 0;
};

}  // namespace ratchet_sieve
