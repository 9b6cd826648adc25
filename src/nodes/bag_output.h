#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// A bag that takes the frames of a run. A library of its own writes it, which sieve_run loads for --bag
/// only, so that other runs need not load ROS.
struct BagOutput
{
  std::shared_ptr<FrameSink> sink;
  std::function<void()> close;  ///< finishes the file @throws std::runtime_error
};

/// The function of that library which opens a bag. @throws std::runtime_error
using OpenBagPlugin = void(const std::string& path, BagOutput& bag);
constexpr const char* BAG_PLUGIN_FUNCTION = "ratchetSieveOpenBag";

}  // namespace ratchet_sieve
