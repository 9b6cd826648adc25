#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/ros/bag_error.h"

namespace ratchet_sieve
{

/// Hands a recorded run to the sink in the order of the frames' stamps. A bag made by `rosbag record` does
/// not keep that order exactly. Frames of the same time come in a fixed order, the scene first. Topics are
/// recognised by their types, so the node's name does not matter.
/// @throws BagError if the file is missing, no bag, damaged, not closed, from another version of the
/// messages, or does not contain exactly one run
void readBag(const std::string& path, FrameSink& sink);

/// The same for a split recording: its files, in any order.
/// @param paths at least one
/// @throws BagError if a file is bad as above or belongs to another run, or if a file in between is missing
void readBags(const std::vector<std::string>& paths, FrameSink& sink);

}  // namespace ratchet_sieve
