#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{

class BagFile;

/// A bag that cannot be read or written. One line names the file and the error.
struct BagError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Hands a recorded run to the sink in the order of the frames' stamps. A bag made by `rosbag record` does
/// not keep that order exactly. Frames of the same time come in a fixed order, the scene first. Topics are
/// recognised by their types, so the node's name does not matter.
/// @param paths a bag, or all files of a split recording, in any order
/// @throws BagError if a file is missing, no bag, damaged, not closed, from another version of the messages,
/// does not contain exactly one run, or belongs to another run; or if a file in between is missing
void readBags(const std::vector<std::string>& paths, FrameSink& sink);

/// Records a run into a bag (lz4) on the topics of the node, the scene latched. Needs no ROS master. Bag time
/// is the header's stamp. A bag cannot hold time 0; the earliest possible time is used instead. The file has
/// the name FILE.active until the bag is closed. A FILE.active left by a killed program is renamed first, to
/// FILE.unfinished.active, FILE.unfinished2.active and so on.
class BagWriter : public FrameSink
{
public:
  /// @param topic_prefix the node's name: topics are /sieve/particles and so on
  /// @param frame_id of the messages
  /// @throws BagError if the file cannot be written, or is being written by another program
  explicit BagWriter(const std::string& path, const std::string& topic_prefix = "/sieve",
                     const std::string& frame_id = WORLD_FRAME_ID);
  ~BagWriter() override;
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// A setpoint is also recorded as the message on its setpoint topic, so that the bag can be played to a
  /// sieve.
  void take(const AnyFrame& frame) override;

  /// Writes the index and gives the file its final name; where nothing was taken, it is removed, and one of
  /// that name stays. Nothing may be taken afterwards.
  /// @throws BagError if something was lost; the message names the file with the rest
  void close();

  /// Bytes so far; data not yet compressed counts with its full size.
  std::uint64_t size() const;

  const std::string& path() const { return path_; }

private:
  template <typename Message>
  void write(const std::string& topic, double time, const Message& message, bool latched = false);
  void writeSetpoint(const CommandFrame& command);

  std::string path_;
  std::string active_path_;
  std::string topic_prefix_;
  std::string frame_id_;
  std::unique_ptr<BagFile> file_;               ///< null once closed
  std::map<FrameKind, std::uint32_t> written_;  ///< messages of each kind: the next header's seq
};

}  // namespace ratchet_sieve
