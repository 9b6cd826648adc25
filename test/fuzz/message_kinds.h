#pragma once

#include <cstdint>

namespace ratchet_sieve
{

/// What stands before each message in an input of message_fuzz.
enum class MessageKind : std::uint8_t
{
  SCENE,
  PARTICLES,
  BINS,
  BASE,
  STATISTICS,
  COMMAND
};

constexpr int MESSAGE_KINDS = 6;

}  // namespace ratchet_sieve
