#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ratchet_sieve/live/run_control.h"
#include "ratchet_sieve/ros/bag_writer.h"

namespace ratchet_sieve
{

/// What a recording holds, and how it is split. Names in comments are those of the node's parameters.
struct RecordingParameters
{
  /// ~recording/particles, bins, base, statistics: frames per second of simulated time; 0: not recorded.
  /// Disks are nearly all of the bytes and seldom needed as often as they are published; of six
  /// published frames one is recorded, which is one of them bit for bit.
  FrameRates rates = {10.0, 60.0, 60.0, 10.0};
  double split_size = 0.0;      ///< ~recording/split_size: of a file [MB]; 0: never split
  double split_duration = 0.0;  ///< ~recording/split_duration: of a file, simulated [s]; 0: never split

  bool splits() const { return split_size > 0.0 || split_duration > 0.0; }
};

/// Records runs, as long as the disk lets it: what cannot be written is an error in the log and in
/// failure(), and the run goes on.
///
/// Each run has a bag of its own, as one that held two could be read by nobody: FILE, and after a reset
/// FILE with _run2, _run3 and so on before its ending. A recording that is split has FILE_0, FILE_1, ...,
/// and FILE_run2_0, ... Each file begins with the scene, at the time at which the one before it ends;
/// frames of one time are never parted.
class Recorder : public RunRecording
{
public:
  /// @param path of the recording; a relative one is that of the directory in which the program is now;
  /// empty: nothing is recorded
  /// @param frame_id of the messages
  Recorder(const std::string& path, const std::string& topic_prefix,
           const RecordingParameters& parameters = RecordingParameters(),
           const std::string& frame_id = WORLD_FRAME_ID);

  /// Opens the file of the first run. @throws BagError
  void open();

  /// Ends the recording of a run and opens the file of the next.
  void openNext() override;

  /// Closes the file. What comes afterwards is not recorded.
  void close() override;

  bool on() const override { return !base_path_.empty(); }
  const FrameRates& rates() const override { return parameters_.rates; }

  /// The file that is being written, its absolute path; empty if none is.
  std::string path() const { return bag_ ? bag_->path() : std::string(); }
  double megabytes() const;  ///< of that file

  /// Why the recording of this run broke off; empty if it did not.
  const std::string& failure() const { return failure_; }

  /// Why the recording of any run so far broke off first; empty if none did.
  const std::string& firstFailure() const { return first_failure_; }

  bool wants(FrameKind kind) const override;
  void take(const AnyFrame& frame) override;

private:
  void write(double time, const std::function<void()>& write);

  void openFile();
  void splitBefore(double time);
  bool full() const;
  void giveUp(const BagError& error);
  std::string nextPath() const;

  std::string base_path_;
  std::string topic_prefix_;
  std::string frame_id_;
  RecordingParameters parameters_;
  int run_ = 0;   ///< from 1
  int file_ = 0;  ///< of the run, from 0
  SceneFrame scene_;
  double file_start_ = 0.0;  ///< [s]
  double last_time_ = 0.0;   ///< of what was recorded last [s]
  std::unique_ptr<BagWriter> bag_;
  std::string failure_;
  std::string first_failure_;
};

}  // namespace ratchet_sieve
