#pragma once

#include <utility>

#include <ros/time.h>

#include "ratchet_sieve/BaseState.h"
#include "ratchet_sieve/BinCounts.h"
#include "ratchet_sieve/Command.h"
#include "ratchet_sieve/Observations.h"
#include "ratchet_sieve/ParticleStates.h"
#include "ratchet_sieve/SceneDescription.h"
#include "ratchet_sieve/SieveStatistics.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/ros/frame_names.h"

/// Conversion of frames to messages, in frame world, and back. A frame converted to a message and back is the
/// same bit for bit.
namespace ratchet_sieve
{

/// Simulated time as a stamp, to the nearest nanosecond. @param time [s], >= 0
ros::Time stampOf(double time);

/// Whether a stamp can represent this time [s]: it has 32 bits of seconds.
bool isStamp(double time);

SceneDescription toMessage(const SceneFrame& frame);
ParticleStates toMessage(const ParticleFrame& frame);
BinCounts toMessage(const BinFrame& frame);
BaseState toMessage(const BaseFrame& frame);
SieveStatistics toMessage(const StatisticsFrame& frame);
Observations toMessage(const ObservedFrame& frame);
Command toMessage(const CommandFrame& frame);

template <typename Frame>
using MessageOf = decltype(toMessage(std::declval<Frame>()));

/// The message with another frame_id, for a sieve mounted elsewhere in the world.
template <typename Message>
Message inFrame(const std::string& frame_id, Message message)
{
  message.header.frame_id = frame_id;
  return message;
}

/// @throws std::invalid_argument if arrays of one message differ in length, or a kind is unknown
SceneFrame toFrame(const SceneDescription& message);
ParticleFrame toFrame(const ParticleStates& message);
BinFrame toFrame(const BinCounts& message);
BaseFrame toFrame(const BaseState& message);
StatisticsFrame toFrame(const SieveStatistics& message);
ObservedFrame toFrame(const Observations& message);
CommandFrame toFrame(const Command& message);

}  // namespace ratchet_sieve
