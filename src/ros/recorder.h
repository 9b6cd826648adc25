#pragma once

#include <memory>
#include <string>

#include "ratchet_sieve/live/run_control.h"
#include "ratchet_sieve/ros/bag.h"

namespace ratchet_sieve
{

/// The contents of a recording and how it is split. The comments give the names of the node's parameters.
struct RecordingParameters
{
  /// ~recording/particles, bins, base, statistics, observed: frames per second of simulated time; 0: not
  /// recorded. Disks take nearly all of the bytes and are seldom needed at the rate of publishing. By default
  /// every sixth published frame is recorded, bit for bit.
  FrameRates rates = {10.0, 60.0, 60.0, 10.0, 1.0};
  double split_size = 0.0;      ///< ~recording/split_size: largest file size [MB]; 0: not split
  double split_duration = 0.0;  ///< ~recording/split_duration: longest file, simulated [s]; 0: not split

  bool splits() const { return split_size > 0.0 || split_duration > 0.0; }
};

/// Records runs. If the disk is full or fails, the error goes to the log and to failure(), and the run
/// continues.
///
/// Each run has its own bag, because a bag with two runs cannot be analysed: FILE, and after a reset FILE
/// with _run2, _run3 and so on before its extension. A split recording has FILE_0, FILE_1, ..., and
/// FILE_run2_0, ... Each file begins with the scene, at the time at which the previous one ends. Frames of
/// one time are always in the same file.
class Recorder : public RunRecording
{
public:
  /// @param path of the recording, relative to the present directory; empty: no recording
  /// @param frame_id of the messages
  Recorder(const std::string& path, const std::string& topic_prefix,
           const RecordingParameters& parameters = RecordingParameters(),
           const std::string& frame_id = WORLD_FRAME_ID);

  /// Opens the file of the first run. @throws BagError
  void open();

  /// Closes the recording of a run and opens the file of the next.
  void openNext() override;

  /// Closes the file. Later frames are not recorded.
  void close() override;

  bool on() const override { return !base_path_.empty(); }
  const FrameRates& rates() const override { return parameters_.rates; }

  /// Absolute path of the file that is being written; empty if there is none.
  std::string path() const { return bag_ ? bag_->path() : std::string(); }
  double megabytes() const;  ///< of that file

  /// Why the recording of this run was aborted; empty if it was not.
  const std::string& failure() const { return failure_; }

  /// Why the recording of a run was aborted for the first time; empty if none was.
  const std::string& firstFailure() const { return first_failure_; }

  bool wants(FrameKind kind) const override;
  void take(const AnyFrame& frame) override;

private:
  void openFile();
  void splitBefore(double time);
  bool full() const;
  void giveUp(const BagError& error);

  std::string base_path_;
  std::string topic_prefix_;
  std::string frame_id_;
  RecordingParameters parameters_;
  int run_ = 0;   ///< from 1
  int file_ = 0;  ///< index within the run, from 0
  SceneFrame scene_;
  double file_start_ = 0.0;  ///< [s]
  double last_time_ = 0.0;   ///< time of the last recorded frame [s]
  std::unique_ptr<BagWriter> bag_;
  std::string failure_;
  std::string first_failure_;
};

}  // namespace ratchet_sieve
