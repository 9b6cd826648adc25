#pragma once

#include "ratchet_sieve/recording/frame_sink.h"

/// Interface of the library that sieve_run loads for --bag only, so that other runs need not load ROS.
namespace ratchet_sieve
{

/// A bag being written.
class BagPlugin
{
public:
  virtual ~BagPlugin() = default;

  virtual FrameSink& sink() = 0;

  /// Finishes the file. @throws std::runtime_error
  virtual void close() = 0;
};

/// Opens a bag; the caller deletes it. @throws std::runtime_error
using OpenBagPlugin = BagPlugin*(const char* path);

/// The library, in the library path of the program, and the function in it.
constexpr const char* BAG_PLUGIN_FILE = "libratchet_sieve_bag_plugin.so";
constexpr const char* BAG_PLUGIN_FUNCTION = "ratchetSieveOpenBag";

}  // namespace ratchet_sieve
