#pragma once

#include <memory>
#include <string>

#include "ratchet_sieve/ros/bag_writer.h"

namespace ratchet_sieve
{

/// Records runs, a bag for each: FILE, and after a reset FILE with _2, _3 and so on before its
/// ending. A bag that held two runs could be read by nobody.
class Recorder : public FrameSink
{
public:
  /// @param path of the first bag; empty: nothing is recorded
  Recorder(const std::string& path, const std::string& topic_prefix);

  /// Opens the bag of the run that begins; closes that of the run before. @throws BagError
  void open();

  /// Closes the bag. What comes afterwards is not recorded. @throws BagError
  void close();

  /// The bag that is being written; empty if none is.
  std::string path() const { return bag_ ? bag_->path() : std::string(); }

  bool wants(FrameKind) const override { return bag_ != nullptr; }
  void take(const SceneFrame& frame) override { pass(frame); }
  void take(const ParticleFrame& frame) override { pass(frame); }
  void take(const BinFrame& frame) override { pass(frame); }
  void take(const BaseFrame& frame) override { pass(frame); }
  void take(const StatisticsFrame& frame) override { pass(frame); }
  void take(const CommandFrame& frame) override { pass(frame); }

private:
  template <typename Frame>
  void pass(const Frame& frame)
  {
    if (bag_)
      bag_->take(frame);
  }

  std::string first_path_;
  std::string topic_prefix_;
  int opened_ = 0;  ///< bags so far
  std::unique_ptr<BagWriter> bag_;
};

}  // namespace ratchet_sieve
