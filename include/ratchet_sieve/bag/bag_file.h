#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/time.h>

#include "ratchet_sieve/bag/bag_error.h"

namespace ratchet_sieve
{

/// A bag of format 2.0 (wiki.ros.org/Bags/Format/2.0) as it is written, packed with lz4. rosbag's own
/// writer ends the program where the disk is full, for it throws from a destructor then, and can be
/// asked neither to finish a chunk nor to leave one out.
///
/// A chunk is written to the file at once, with its index. However the program ends, all chunks but the last
/// are complete, and `rosbag reindex` recovers them. It is finished as soon as it holds
/// CHUNK_SIZE bytes, or messages of CHUNK_DURATION.
class BagFile
{
public:
  static constexpr std::size_t CHUNK_SIZE = 768 * 1024;  ///< before packing [bytes]; as rosbag has
  static constexpr double CHUNK_DURATION = 1.0;          ///< of simulated time [s]

  /// Overwrites what is there. @throws BagError where the file cannot be written, or another program writes
  /// it
  explicit BagFile(const std::string& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// Whether some BagFile, of this program or another, is open at this path.
  static bool isBeingWritten(const std::string& path);

  /// @param time not earlier than that of the message before
  /// @param latched whether a replay is to keep it for who subscribes later
  /// @throws BagError; then all that can still be done is to close
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

  /// Bytes in the file, and those that wait to be packed.
  std::uint64_t size() const { return end_ + chunk_.size(); }

  /// How a file ended that could not be written to its end.
  struct Loss
  {
    std::string reason;
    ros::Time end;  ///< of the last message that is in the file
  };

  /// Finishes the file. Where there is no room for its index, chunks make room for it, from the last on.
  /// As long as this lives the file stays locked: nobody takes it for one to set aside before it has its
  /// name.
  /// @return what was lost, if anything was
  /// @throws BagError where the file could not be given an index: `rosbag reindex` can
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
    std::uint32_t offset;  ///< in the chunk, unpacked
  };

  struct Chunk
  {
    std::uint64_t position;   ///< in the file
    ros::Time end;            ///< of its last message
    std::size_t info_offset;  ///< of what chunk_infos_ says of it
  };

  void startMessage(ros::Time time);
  std::uint32_t connectionOf(const Connection& connection);
  void finishMessage(std::uint32_t connection, ros::Time time);
  void endChunk();
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
  std::uint64_t end_ = 0;  ///< of the last whole chunk
  std::vector<Connection> connections_;
  std::vector<Chunk> chunks_;
  std::string chunk_infos_;  ///< records of the file's index, one to a chunk

  std::string chunk_;  ///< that is being filled, unpacked
  ros::Time chunk_start_, chunk_end_;
  std::vector<std::vector<IndexEntry>> chunk_index_;  ///< of each connection

  // Kept from chunk to chunk for their memory: allocated again each time, in sizes that differ, they
  // leave holes between what stays, and a process of some hundreds of megabytes in an hour.
  std::vector<std::uint8_t> bytes_;  ///< of a message
  std::string packed_, record_;      ///< of a chunk

  int failure_ = 0;  ///< errno where nothing more can be written
};

}  // namespace ratchet_sieve
