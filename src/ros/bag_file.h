#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <rosbag/bag.h>

#include "ratchet_sieve/recording/locked_file.h"
#include "ratchet_sieve/ros/bag.h"

namespace ratchet_sieve
{

/// A rosbag::Bag (lz4) that can be read although the disk became full or the program was killed.
///
/// Room for the end of the bag is set aside on the disk before each message is written, so that the bag can
/// still be closed on a full disk. A chunk holds at most CHUNK_DURATION of messages. If the program is
/// killed, `rosbag reindex` recovers all chunks but the last.
class BagFile
{
public:
  static constexpr std::uint32_t CHUNK_SIZE = 768 * 1024;  ///< before compression, rosbag's default [bytes]
  static constexpr double CHUNK_DURATION = 1.0;            ///< of simulated time [s]

  /// Overwrites an existing file. @throws BagError if the file cannot be written, or is being written by
  /// another program
  explicit BagFile(const std::string& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// @param time not earlier than the time of the previous message
  /// @param latched whether a replay keeps the message for later subscribers
  /// @throws BagError if the disk is full or fails; then only close() can still be called
  template <typename Message>
  void write(const std::string& topic, ros::Time time, const Message& message, bool latched = false)
  {
    namespace traits = ros::message_traits;
    boost::shared_ptr<ros::M_string> header;
    if (latched)
      header =
          boost::make_shared<ros::M_string>(ros::M_string{{"type", traits::datatype(message)},
                                                          {"md5sum", traits::md5sum(message)},
                                                          {"message_definition", traits::definition(message)},
                                                          {"latching", "1"}});
    try
    {
      startMessage(topic, traits::definition(message), time,
                   ros::serialization::serializationLength(message));
      bag_->write(topic, time, message, header);
    }
    catch (const ros::Exception& error)
    {
      abandon(error.what());
    }
  }

  /// Whether a message was written.
  bool hasBegun() const { return written_ > 0; }

  /// Bytes in the file, and bytes not yet compressed.
  std::uint64_t size() const;

  /// The end of a file that could not be written completely.
  struct Loss
  {
    std::string reason;
    ros::Time end;  ///< time of the last message in the file
  };

  /// Finishes the file. It stays locked as long as this object lives, so that no other program sets it aside
  /// before it has its final name.
  /// @return the loss, if anything was lost
  /// @throws BagError if no index could be written: `rosbag reindex` can add one
  std::optional<Loss> close();

private:
  void startMessage(const std::string& topic, const char* definition, ros::Time time, std::uint64_t size);
  void divideAt(ros::Time time);
  void endChunk();
  bool isDivided() const;
  int makeRoom(std::uint64_t bytes);
  std::uint64_t largestSize() const;
  int reserve(std::uint64_t size);
  std::uint64_t sizeOnDisk() const;
  [[noreturn]] void abandon(const std::string& reason);

  LockedFile lock_;                   ///< has the room set aside
  std::unique_ptr<rosbag::Bag> bag_;  ///< null once it is closed or abandoned
  std::uint64_t reserved_ = 0;        ///< largest size of the file for which room is set aside
  std::set<std::string> topics_;
  std::uint64_t connections_ = 0;   ///< size of the topics' records
  std::uint64_t chunks_ = 1;        ///< not counting those that were ended for their size
  std::uint64_t written_ = 0;       ///< size of all messages
  std::uint64_t uncompressed_ = 0;  ///< size of the messages that may not be in the file yet
  ros::Time chunk_start_;           ///< of the first message since the last endChunk()
  ros::Time end_;                   ///< of the last message
  std::string failure_;             ///< why nothing more is written
};

}  // namespace ratchet_sieve
