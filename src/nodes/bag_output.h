#pragma once

#include <memory>
#include <string>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// A bag that takes the frames of a run. Without ROS it cannot be opened.
class BagOutput
{
public:
  /// @throws std::runtime_error if it cannot be written or this build has no ROS
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
