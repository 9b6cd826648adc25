#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/bag/bag_error.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Hands a recorded run to the sink, in the order of the frames' own times (which a bag made by
/// `rosbag record` does not quite keep), frames of one time in a fixed order, the scene first.
/// Topics are known by their types, whatever the node was called.
/// @throws BagError where the file is missing, no bag, damaged, not closed, from another version of
/// the messages, or does not hold exactly one run
void readBag(const std::string& path, FrameSink& sink);

/// The same of a run whose recording was split: its files, in any order, as if they were one.
/// @param paths one at least
/// @throws BagError where one is bad as above, is of another run, or where one between others is missing
void readBags(const std::vector<std::string>& paths, FrameSink& sink);

/// That a sieve can be shown from a bag that is played: it is sound, and holds a scene. It may hold other
/// things besides, several sieves, or a part of a run.
/// @param sieve name of the node whose run it is to be; empty: any
/// @throws BagError
void requireShowable(const std::string& path, const std::string& sieve);

}  // namespace ratchet_sieve
