#include "ratchet_sieve/ros/conversions.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <ros/serialization.h>

#include "random_frames.h"
#include "ratchet_sieve/recording/same_bits.h"

namespace ratchet_sieve
{
namespace
{
/// A message as it arrives after a way over the wire.
template <typename Message>
Message overTheWire(const Message& message)
{
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
  ros::serialization::IStream stream(bytes.message_start, bytes.num_bytes - 4);
  Message arrived;
  ros::serialization::deserialize(stream, arrived);
  return arrived;
}

template <typename Frame>
void expectRoundTrip(Frame (*anyFrame)())
{
  EXPECT_TRUE(rc::check(
      [=]
      {
        const Frame frame = anyFrame();
        RC_ASSERT(sameBits(toFrame(overTheWire(toMessage(frame))), frame));
      }));
}

TEST(Conversions, keepEveryBitOfAScene)
{
  expectRoundTrip(anySceneFrame);
}

TEST(Conversions, keepEveryBitOfParticles)
{
  expectRoundTrip(anyParticleFrame);
}

TEST(Conversions, keepEveryBitOfBins)
{
  expectRoundTrip(anyBinFrame);
}

TEST(Conversions, keepEveryBitOfTheBase)
{
  expectRoundTrip(anyBaseFrame);
}

TEST(Conversions, keepEveryBitOfStatistics)
{
  expectRoundTrip(anyStatisticsFrame);
}

TEST(Conversions, keepEveryBitOfACommand)
{
  expectRoundTrip(anyCommandFrame);
}

TEST(Conversions, stampToTheNearestNanosecond)
{
  EXPECT_EQ(stampOf(0.0), ros::Time(0, 0));
  EXPECT_EQ(stampOf(1.0 / 60.0), ros::Time(0, 16666667));
  EXPECT_EQ(stampOf(1000000.0 + 2.0 / 3.0), ros::Time(1000000, 666666667));
  EXPECT_EQ(stampOf(0.9999999999), ros::Time(1, 0));
}

TEST(Conversions, stampInTheWorldFrame)
{
  BaseFrame frame;
  frame.time = 2.5;
  const BaseState message = toMessage(frame);
  EXPECT_EQ(message.header.stamp, ros::Time(2, 500000000));
  EXPECT_EQ(message.header.frame_id, "world");
}

TEST(Conversions, sayUndefinedByAFlagAndZero)
{
  BinFrame frame;
  frame.processed = 0.25;
  const BinCounts message = toMessage(frame);
  EXPECT_FALSE(message.quality_defined);
  EXPECT_EQ(message.quality, 0.0);
  EXPECT_TRUE(message.processed_defined);
  EXPECT_EQ(message.processed, 0.25);
}

TEST(Conversions, refuseArraysOfDifferentLengths)
{
  ParticleStates particles;
  particles.id = {1, 2};
  try
  {
    toFrame(particles);
    FAIL() << "taken";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(), "species has 0 entries, not 2");
  }
  BinCounts bins;
  bins.left = {1};
  EXPECT_THROW(toFrame(bins), std::invalid_argument);
}
}  // namespace
}  // namespace ratchet_sieve
