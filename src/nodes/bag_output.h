#pragma once

#include <memory>
#include <string>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// A bag that takes the frames of a run. A library of its own writes it, which sieve_run loads for --bag
/// only, so that other runs need not load ROS.
class BagOutput : public FrameSink
{
public:
  /// Finishes the file. @throws std::runtime_error
  virtual void close() = 0;
};

/// @throws std::runtime_error if it cannot be written or this build has no ROS
std::unique_ptr<BagOutput> openBag(const std::string& path);

/// The function of that library which opens a bag; the caller deletes it. @throws std::runtime_error
using OpenBagPlugin = BagOutput*(const char* path);
constexpr const char* BAG_PLUGIN_FUNCTION = "ratchetSieveOpenBag";

}  // namespace ratchet_sieve
