#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "bag_record.h"

namespace ratchet_sieve
{

/// One chunk of a bag: the positions of its messages, and which of them are in the index.
class BagChunk
{
public:
  /// Decompresses the chunk and checks its content.
  /// @throws DamagedBag if it does not decompress to its declared size, or contains an invalid record
  explicit BagChunk(const BagRecord& record);

  /// The declared uncompressed size of a chunk [bytes].
  static std::uint32_t claimedSize(const BagRecord& record) { return record.fields.number("size"); }

  /// Takes an index record of this chunk.
  /// @throws DamagedBag if an entry is no message of its connection, or occurs twice
  void takeIndex(const BagRecord& record);

  /// @throws DamagedBag if a message is not in the index
  void requireIndexed() const;

  std::size_t indexRecords() const { return index_records_; }

  /// Recording time of each message, in the order of the index [ns].
  const std::vector<std::uint64_t>& times() const { return times_; }

private:
  void readMessages(std::string_view unpacked);

  std::map<std::size_t, std::size_t>
      entries_;  ///< offsets to which the index may point, and the offset of the message
  std::map<std::size_t, std::uint32_t>
      unindexed_;  ///< messages not in the index so far, by offset: connection
  std::vector<std::uint64_t> times_;
  std::size_t index_records_ = 0;
};

}  // namespace ratchet_sieve
