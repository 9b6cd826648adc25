#pragma once

#include "ratchet_sieve/recording/frame_sink.h"

/// What sieve_run asks of the library that it loads for --bag: ROS's libraries stay out of a run without.
namespace ratchet_sieve
{

/// A bag that is being written.
class BagPlugin
{
public:
  virtual ~BagPlugin() = default;

  virtual FrameSink& sink() = 0;

  /// Finishes the file. @throws std::runtime_error
  virtual void close() = 0;
};

/// Opens a bag, which the caller deletes. @throws std::runtime_error
using OpenBagPlugin = BagPlugin*(const char* path);

/// The library, found where those are that the program is linked to, and the function in it.
constexpr const char* BAG_PLUGIN_FILE = "libratchet_sieve_bag_plugin.so";
constexpr const char* BAG_PLUGIN_FUNCTION = "ratchetSieveOpenBag";

}  // namespace ratchet_sieve
