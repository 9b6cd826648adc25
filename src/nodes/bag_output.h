#pragma once

#include <memory>
#include <string>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// A bag that takes a run's frames, whether or not this build has the ROS that it takes.
class BagOutput
{
public:
  /// @throws std::runtime_error if it cannot be written, or if this build has no ROS
  explicit BagOutput(const std::string& path);
  ~BagOutput();

  FrameSink& sink();

  /// Finishes the file. @throws std::runtime_error
  void close();

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ratchet_sieve
