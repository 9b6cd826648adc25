#include "bounded_stream.h"

#include <cstring>

#include <gtest/gtest.h>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{

/// Size before the first array of a message: seq, stamp, frame_id and time, and this many numbers [bytes].
constexpr std::size_t beforeArrays(std::size_t numbers)
{
  return 4 + 8 + 4 + 5 + 8 + 8 * numbers;
}

template <typename Message>
std::vector<std::uint8_t> serialized(const Message& message)
{
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

/// Reads a message whose first array declares another length.
/// @param numbers between its time and its first array
template <typename Message>
void readWithLength(const Message& message, std::uint32_t length, std::size_t numbers)
{
  std::vector<std::uint8_t> bytes = serialized(message);
  std::memcpy(bytes.data() + beforeArrays(numbers), &length, sizeof length);
  Message read;
  BoundedStream(bytes).next(read);
}

/// The last two lengths, multiplied by the entry's size, overflow to a small number in 32 bits.
const std::uint32_t LENGTHS[] = {1000, 0x7fffffff, 0xffffffff, 0x20000001, 0x40000001};

TEST(BoundedStream, ReadsWhatWasWritten)
{
  ParticleFrame frame;
  frame.disks.resize(3);
  frame.disks[2].spin = 0.5;
  std::vector<std::uint8_t> bytes = serialized(toMessage(frame));
  ParticleStates read;
  BoundedStream(bytes).next(read);
  EXPECT_EQ(read, toMessage(frame));
}

TEST(BoundedStream, RefusesAnArrayThatTheMessageIsTooShortFor)
{
  ParticleFrame particles;
  particles.disks.resize(3);
  StatisticsFrame statistics;
  statistics.species.resize(1);
  for (const std::uint32_t length : LENGTHS)
  {
    EXPECT_THROW(readWithLength(toMessage(particles), length, 0), std::invalid_argument) << length;
    EXPECT_THROW(readWithLength(toMessage(statistics), length, 2), std::invalid_argument) << length;
  }
}

TEST(BoundedStream, RefusesAMessageThatEndsEarly)
{
  const std::vector<std::uint8_t> whole = serialized(toMessage(SceneFrame()));
  for (std::size_t size = 0; size < whole.size(); ++size)
  {
    std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    SceneDescription read;
    EXPECT_THROW(BoundedStream(cut).next(read), ros::serialization::StreamOverrunException) << size;
  }
}

}  // namespace
}  // namespace ratchet_sieve
