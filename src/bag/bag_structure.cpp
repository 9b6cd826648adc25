#include "ratchet_sieve/bag/bag_structure.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "bag_chunk.h"
#include "bag_record.h"
#include "mapped_file.h"
#include "ratchet_sieve/bag/bag_error.h"

namespace ratchet_sieve
{
namespace
{

/// Largest uncompressed size of a bag in multiples of its own size: the limit of lz4, and more than numbers
/// ever reach, ...
constexpr std::size_t MOST_RATIO = 255;
/// ... plus this, so that a short bz2 recording of disks at rest is accepted [bytes].
constexpr std::size_t UNPACKED_ANYWAY = std::size_t{16} << 20;
/// How often, on average, a chunk may have to be decompressed to read the messages in the order of time: more
/// than a recorder's delays can cause.
constexpr std::size_t MOST_UNPACKINGS = 16;
/// More than any recorder writes; rosbag doubles a buffer of 32-bit size until a chunk fits [bytes].
constexpr std::size_t LARGEST_CHUNK = std::size_t{1} << 30;

/// A connection in a chunk's info: its number and a count, each of 32 bits [bytes].
constexpr std::size_t CHUNK_INFO_ENTRY_SIZE = 8;

/// A bag that has no index: one that is still being written, or whose writer died.
struct UnclosedBag
{
};

class BagStructure
{
public:
  explicit BagStructure(std::string_view bytes) : rest_(bytes) {}

  void check()
  {
    readHead();
    readChunks();
    readConnections();
    readChunkInfos();
    if (!rest_.atEnd())
      throw DamagedBag("it continues after its index");
    requireOrder();
  }

  void readHead()
  {
    if (rest_.size() < VERSION_LINE.size() || rest_.take(VERSION_LINE.size()) != VERSION_LINE)
      throw DamagedBag("it is not of format 2.0");
    const BagRecord head = rest_.takeRecord();
    head.requireOp(BagOp::FILE_HEADER);
    if (head.fields.has("encryptor") && !head.fields.text("encryptor").empty())
      throw DamagedBag("it is encrypted");
    index_position_ = head.fields.position("index_pos");
    connections_ = head.fields.number("conn_count");
    chunk_infos_ = head.fields.number("chunk_count");
    if (index_position_ == 0 || index_position_ > rest_.size())
      throw UnclosedBag();
  }

private:
  /// The chunks, each followed by its index.
  void readChunks()
  {
    std::optional<BagChunk> chunk;
    ChunkSize chunk_size;
    const auto finish_chunk = [&]
    {
      if (!chunk)
        return;
      chunk->requireIndexed();
      for (const std::uint64_t time : chunk->times())
        messages_.push_back({time, chunk_size});
      index_records_[chunk_size.position] = chunk->indexRecords();
    };
    while (rest_.position() < index_position_)
    {
      const std::size_t position = rest_.position();
      const BagRecord record = rest_.takeRecord();
      if (chunk && record.fields.op() == BagOp::INDEX)
      {
        chunk->takeIndex(record);
        indexed_connections_.insert(record.fields.number("conn"));
        continue;
      }
      finish_chunk();
      record.requireOp(BagOp::CHUNK);
      chunk_size = {position, BagChunk::claimedSize(record)};
      requirePlausible(chunk_size.bytes);
      chunk.emplace(record);
    }
    finish_chunk();
    if (rest_.position() != index_position_)
      throw DamagedBag("its index is not where its header says");
  }

  /// Checked before memory is allocated for it.
  void requirePlausible(std::size_t chunk_size)
  {
    unpacked_size_ += chunk_size;
    if (chunk_size > LARGEST_CHUNK || unpacked_size_ > MOST_RATIO * rest_.size() + UNPACKED_ANYWAY)
      throw DamagedBag("its declared uncompressed size is too large");
  }

  /// rosbag keeps one chunk decompressed and reads in the order of time. So chunks with interleaved messages
  /// are decompressed again for each message.
  void requireOrder()
  {
    std::sort(messages_.begin(), messages_.end(),
              [](const Message& a, const Message& b)
              { return std::tie(a.time, a.chunk.position) < std::tie(b.time, b.chunk.position); });
    std::size_t unpacked = 0;
    for (std::size_t i = 0; i < messages_.size(); ++i)
      if (i == 0 || messages_[i].chunk.position != messages_[i - 1].chunk.position)
        unpacked += messages_[i].chunk.bytes;
    if (unpacked > MOST_UNPACKINGS * unpacked_size_ + UNPACKED_ANYWAY)
      throw DamagedBag(
          "its messages alternate between chunks; `rosbag filter IN OUT True` puts them in order");
  }

  void readConnections()
  {
    for (std::uint32_t i = 0; i < connections_; ++i)
    {
      const BagRecord record = rest_.takeRecord();
      record.requireOp(BagOp::CONNECTION);
      record.fields.text("topic");
      BagFields connection(record.bytes);
      indexed_connections_.erase(record.fields.number("conn"));
    }
    if (!indexed_connections_.empty())
      throw DamagedBag("messages belong to no connection");
  }

  void readChunkInfos()
  {
    for (std::uint32_t i = 0; i < chunk_infos_; ++i)
    {
      const BagRecord record = rest_.takeRecord();
      record.requireOp(BagOp::CHUNK_INFO);
      const std::uint32_t count = record.fields.number("count");
      const auto chunk = index_records_.find(record.fields.position("chunk_pos"));
      if (record.fields.number("ver") != CHUNK_INFO_VERSION || chunk == index_records_.end() ||
          chunk->second != count || record.bytes.size() != CHUNK_INFO_ENTRY_SIZE * count)
        throw DamagedBag("its information on a chunk does not match the chunk");
      index_records_.erase(chunk);
    }
    if (!index_records_.empty())
      throw DamagedBag("a chunk is missing from its index");
  }

  struct ChunkSize
  {
    std::size_t position = 0;  ///< in the bag
    std::uint32_t bytes = 0;   ///< unpacked
  };

  struct Message
  {
    std::uint64_t time;  ///< [ns]
    ChunkSize chunk;
  };

  BagBytes rest_;
  std::vector<Message> messages_;
  std::size_t index_position_ = 0;
  std::uint32_t connections_ = 0;
  std::uint32_t chunk_infos_ = 0;
  std::size_t unpacked_size_ = 0;                       ///< declared total of the chunks so far [bytes]
  std::set<std::uint32_t> indexed_connections_;         ///< that have messages
  std::map<std::uint64_t, std::size_t> index_records_;  ///< of each chunk, by its position
};

}  // namespace

void requireSoundBag(const std::string& path)
{
  const MappedFile file(path);
  try
  {
    BagStructure(file.bytes()).check();
  }
  catch (const UnclosedBag&)
  {
    throw BagError(path + ": was not closed, or is damaged: try `rosbag reindex`");
  }
  catch (const DamagedBag& error)
  {
    throw BagError(path + ": cannot be read as a bag: " + error.what());
  }
}

bool isIndexedBag(const std::string& path)
{
  try
  {
    const MappedFile file(path);
    BagStructure(file.bytes()).readHead();
    return true;
  }
  catch (const UnclosedBag&)
  {
    return false;
  }
  catch (const std::runtime_error&)  // no bag, or unreadable
  {
    return false;
  }
}

}  // namespace ratchet_sieve
