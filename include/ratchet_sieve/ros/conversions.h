#pragma once

#include <string>
#include <utility>

#include "ratchet_sieve/BaseState.h"
#include "ratchet_sieve/BinCounts.h"
#include "ratchet_sieve/Command.h"
#include "ratchet_sieve/DiskExit.h"
#include "ratchet_sieve/Observations.h"
#include "ratchet_sieve/ParticleStates.h"
#include "ratchet_sieve/Purity.h"
#include "ratchet_sieve/SceneDescription.h"
#include "ratchet_sieve/SieveStatistics.h"
#include "ratchet_sieve/recording/frames.h"

/// Conversion of frames to messages, in frame world, and back. A frame converted to a message and back is the
/// same bit for bit.
namespace ratchet_sieve
{

/// The frame that all sieves share: x to the right, z up (y of the plane).
constexpr const char* WORLD_FRAME_ID = "world";

/// Whether a stamp can represent this time [s]: it has 32 bits of seconds.
bool isStamp(double time);

SceneDescription toMessage(const SceneFrame& frame, const std::string& frame_id = WORLD_FRAME_ID);
ParticleStates toMessage(const ParticleFrame& frame, const std::string& frame_id = WORLD_FRAME_ID);
BinCounts toMessage(const BinFrame& frame, const std::string& frame_id = WORLD_FRAME_ID);
BaseState toMessage(const BaseFrame& frame, const std::string& frame_id = WORLD_FRAME_ID);
SieveStatistics toMessage(const StatisticsFrame& frame, const std::string& frame_id = WORLD_FRAME_ID);
Observations toMessage(const ObservedFrame& frame, const std::string& frame_id = WORLD_FRAME_ID);
Command toMessage(const CommandFrame& frame, const std::string& frame_id = WORLD_FRAME_ID);

/// @param species its name
DiskExit toMessage(const ExitRecord& exit, const std::string& species, const std::string& frame_id);

/// Purity and recovery of the bins now. @param window_start as of makeBinFrame
Purity purityOf(const Simulation& simulation, double window_start, const std::string& frame_id);

template <typename Frame>
using MessageOf = decltype(toMessage(std::declval<Frame>()));

/// @throws std::invalid_argument if arrays of one message differ in length, or a kind is unknown
SceneFrame toFrame(const SceneDescription& message);
ParticleFrame toFrame(const ParticleStates& message);
BinFrame toFrame(const BinCounts& message);
BaseFrame toFrame(const BaseState& message);
StatisticsFrame toFrame(const SieveStatistics& message);
ObservedFrame toFrame(const Observations& message);
CommandFrame toFrame(const Command& message);

}  // namespace ratchet_sieve
