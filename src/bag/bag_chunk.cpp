#include "bag_chunk.h"

#include <memory>

#include <bzlib.h>
#include <roslz4/lz4s.h>

namespace ratchet_sieve
{
namespace
{

/// An entry of an index: seconds, nanoseconds and offset, each of 32 bits [bytes].
constexpr std::size_t INDEX_ENTRY_SIZE = 12;

constexpr std::uint32_t NANOSECONDS = 1'000'000'000;

/// Decompresses `from` into `to`. Returns whether it is valid and has exactly `to_size` bytes.
/// The two libraries read through pointers that are not const.
bool unpack(std::string_view compression, std::string_view from, char* to, unsigned int to_size)
{
  unsigned int size = to_size;
  char* source = const_cast<char*>(from.data());
  const auto source_size = static_cast<unsigned int>(from.size());
  if (compression == "lz4")
    return roslz4_buffToBuffDecompress(source, source_size, to, &size) == ROSLZ4_OK && size == to_size;
  if (compression == "bz2")
    return BZ2_bzBuffToBuffDecompress(to, &size, source, source_size, 0, 0) == BZ_OK && size == to_size;
  throw DamagedBag("a chunk has an unknown compression");
}

}  // namespace

BagChunk::BagChunk(const BagRecord& record)
{
  record.requireOp(BagOp::CHUNK);
  const std::uint32_t size = claimedSize(record);
  const std::string_view compression = record.fields.text("compression");
  if (compression == "none")
  {
    if (size != record.bytes.size())
      throw DamagedBag("the size of a chunk differs from its header");
    readMessages(record.bytes);
    return;
  }
  // Not initialised, so that a wrong size in the file takes up no more memory than is written.
  const std::unique_ptr<char[]> unpacked(new char[size]);
  if (!unpack(compression, record.bytes, unpacked.get(), size))
    throw DamagedBag("a chunk cannot be decompressed");
  readMessages({unpacked.get(), size});
}

void BagChunk::readMessages(std::string_view unpacked)
{
  BagBytes rest(unpacked);
  // The index may point to connection records before the message.
  std::vector<std::size_t> leading;
  while (!rest.atEnd())
  {
    leading.push_back(rest.position());
    const BagRecord record = rest.takeRecord();
    if (record.fields.op() == BagOp::CONNECTION)
    {
      BagFields connection(record.bytes);
      continue;
    }
    record.requireOp(BagOp::MESSAGE);
    const std::size_t own = leading.back();
    for (const std::size_t offset : leading)
      entries_.emplace(offset, own);
    unindexed_.emplace(own, record.fields.number("conn"));
    leading.clear();
  }
}

void BagChunk::takeIndex(const BagRecord& record)
{
  ++index_records_;
  const std::uint32_t connection = record.fields.number("conn");
  if (record.fields.number("ver") != INDEX_VERSION)
    throw DamagedBag("an index is of an unknown version");
  if (record.bytes.size() != INDEX_ENTRY_SIZE * record.fields.number("count"))
    throw DamagedBag("the size of an index differs from its header");
  BagBytes rest(record.bytes);
  while (!rest.atEnd())
  {
    const std::uint32_t seconds = rest.takeNumber();
    const std::uint32_t nanoseconds = rest.takeNumber();
    if (nanoseconds >= NANOSECONDS || (seconds == 0 && nanoseconds == 0))
      throw DamagedBag("an index has an invalid time");
    const auto entry = entries_.find(rest.takeNumber());
    const auto message = entry == entries_.end() ? unindexed_.end() : unindexed_.find(entry->second);
    if (message == unindexed_.end() || message->second != connection)
      throw DamagedBag("an index entry points to no message");
    unindexed_.erase(message);
    times_.push_back(std::uint64_t{seconds} * NANOSECONDS + nanoseconds);
  }
}

void BagChunk::requireIndexed() const
{
  if (!unindexed_.empty())
    throw DamagedBag("messages are missing from an index");
}

}  // namespace ratchet_sieve
