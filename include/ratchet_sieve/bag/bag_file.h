#pragma once

#include <atomic>
#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/time.h>

#include "ratchet_sieve/bag/bag_error.h"

namespace ratchet_sieve
{

/// Writes a bag of format 2.0 (wiki.ros.org/Bags/Format/2.0), compressed with lz4. rosbag's own writer is not
/// used, for two reasons. On a full disk it throws from a destructor, which ends the program. It can neither
/// be asked to finish a chunk nor to leave one out.
///
/// A chunk is finished when it holds CHUNK_SIZE bytes or CHUNK_DURATION of messages. It is then compressed
/// and written to the file, with its index, in a thread of its own, while the next one is filled. If the
/// program is killed, all chunks but the last two are complete, and `rosbag reindex` recovers them.
class BagFile
{
public:
  static constexpr std::size_t CHUNK_SIZE = 768 * 1024;  ///< before compression, as in rosbag [bytes]
  static constexpr double CHUNK_DURATION = 1.0;          ///< of simulated time [s]

  /// Overwrites an existing file. @throws BagError if the file cannot be written, or is being written by
  /// another program
  explicit BagFile(const std::string& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// Whether this or another program has a BagFile open at this path.
  static bool isBeingWritten(const std::string& path);

  /// @param time not earlier than the time of the previous message
  /// @param latched whether a replay keeps the message for later subscribers
  /// @throws BagError, also for an earlier message that could not be written; then only close() can still be
  /// called
  template <typename Message>
  void write(const std::string& topic, ros::Time time, const Message& message, bool latched = false)
  {
    namespace traits = ros::message_traits;
    startMessage(time);
    const std::uint32_t connection = connectionOf(
        {topic, traits::datatype(message), traits::md5sum(message), traits::definition(message), latched});
    bytes_.resize(ros::serialization::serializationLength(message));
    ros::serialization::OStream stream(bytes_.data(), static_cast<std::uint32_t>(bytes_.size()));
    ros::serialization::serialize(stream, message);
    finishMessage(connection, time);
  }

  /// Bytes in the file, and bytes not yet compressed. Waits for the chunk that is being stored.
  std::uint64_t size() const;

  /// The end of a file that could not be written completely.
  struct Loss
  {
    std::string reason;
    ros::Time end;  ///< time of the last message in the file
  };

  /// Finishes the file. If there is no space for its index, chunks are removed from the end until there is.
  /// The file stays locked as long as this object lives, so that no other program sets it aside before it has
  /// its final name.
  /// @return the loss, if anything was lost
  /// @throws BagError if no index could be written: `rosbag reindex` can add one
  std::optional<Loss> close();

private:
  struct Connection
  {
    std::string topic, type, md5sum, definition;
    bool latched;
  };

  struct IndexEntry
  {
    ros::Time time;
    std::uint32_t offset;  ///< in the uncompressed chunk
  };

  /// The messages of a chunk, uncompressed.
  struct Content
  {
    std::string bytes;
    ros::Time start, end;
    std::vector<std::vector<IndexEntry>> index;  ///< of each connection

    void clear();
  };

  struct Chunk
  {
    std::uint64_t position;   ///< in the file
    ros::Time end;            ///< of its last message
    std::size_t info_offset;  ///< of its record in chunk_infos_
  };

  void startMessage(ros::Time time);
  std::uint32_t connectionOf(const Connection& connection);
  void finishMessage(std::uint32_t connection, ros::Time time);
  void endChunk();
  void waitForStoring();
  void store();
  void pack();
  std::uint32_t appendIndexes(std::string& to, std::string& counts) const;
  std::string headRecord(std::uint64_t index_position) const;
  std::string connectionRecord(std::uint32_t id) const;
  std::string indexOfFile() const;
  void writeAt(std::uint64_t position, const std::string& bytes);
  void writeIndex();
  void makeIndex();
  [[noreturn]] void fail(int error);

  int descriptor_;
  int lock_ = -1;          ///< a second descriptor, once the first is closed
  std::uint64_t end_ = 0;  ///< end of the last complete chunk
  std::vector<Connection> connections_;
  std::vector<Chunk> chunks_;
  std::string chunk_infos_;  ///< records of the file's index, one per chunk

  Content filling_;
  Content storing_;
  std::future<void>
      stored_;  ///< the thread that stores storing_; until it ends, end_ and chunks_ belong to it

  // These buffers are reused for all chunks. Allocating them anew in varying sizes fragments the heap: a
  // process grew by some hundreds of megabytes in an hour.
  std::vector<std::uint8_t> bytes_;  ///< of a message
  std::string packed_, record_;      ///< of a chunk

  std::atomic<int> failure_ = 0;  ///< errno after which nothing more can be written
};

}  // namespace ratchet_sieve
