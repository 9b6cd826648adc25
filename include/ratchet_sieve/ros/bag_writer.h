#pragma once

#include <memory>
#include <string>

#include "ratchet_sieve/bag/bag_file.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/ros/frame_names.h"

namespace ratchet_sieve
{

/// Records a run into a bag (lz4), on the topics on which the node publishes it, the scene latched. Needs no
/// ROS master. Bag time is the header's stamp; at time 0, which no bag holds, the earliest there is. The file
/// appears under its name when the bag is closed; until then it is FILE.active. What a program that was
/// killed has left under that name is set aside first, as FILE.unfinished.active, FILE.unfinished2.active and
/// so on.
class BagWriter : public FrameSink
{
public:
  /// @param topic_prefix the node's name: topics are /sieve/particles and so on
  /// @param frame_id of the messages
  /// @throws BagError where the file cannot be written, or is being written by another
  explicit BagWriter(const std::string& path, const std::string& topic_prefix = "/sieve",
                     const std::string& frame_id = WORLD_FRAME_ID);
  ~BagWriter() override;
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// A setpoint stands in the bag as it came, too, for whoever plays the bag to a sieve.
  void take(const AnyFrame& frame) override;

  /// Writes the index and gives the file its name. What is taken afterwards is an error.
  /// @throws BagError where something was lost, that says where the rest is
  void close();

  /// Bytes so far; what is not packed yet counts as it is.
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
  std::unique_ptr<BagFile> file_;  ///< nothing once it is closed
};

}  // namespace ratchet_sieve
