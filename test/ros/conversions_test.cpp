#include "ratchet_sieve/ros/conversions.h"

#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <ros/serialization.h>

#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/recording/same_bits.h"

namespace ratchet_sieve
{
namespace
{
/// Fills every described field; all vectors of a frame have one length. Those within its parts are shorter.
class AnyValue
{
public:
  explicit AnyValue(std::size_t longest = 20) : length_(*rc::gen::inRange<std::size_t>(0, longest)) {}

  template <typename T>
  void operator()(const FieldInfo&, T& value) const
  {
    if constexpr (IS_OPTIONAL<T>)
    {
      value.emplace();
      fill(*value);
      if (*rc::gen::arbitrary<bool>())
        value.reset();
    }
    else if constexpr (IS_VECTOR<T>)
    {
      value.resize(length_);
      for (auto& element : value)
        fill(element);
    }
    else
      fill(value);
  }

private:
  template <typename T>
  void fill(T& value) const
  {
    if constexpr (IS_DESCRIBED<T>)
      Fields<T>::each(AnyValue(4), value);
    else if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(*rc::gen::inRange<int>(0, COMMAND_KINDS));
    else if constexpr (IS_OPTIONAL<T>)
      value = *rc::gen::arbitrary<bool>() ? std::optional(*rc::gen::arbitrary<typename T::value_type>())
                                          : std::nullopt;
    else
      value = *rc::gen::arbitrary<T>();
  }

  std::size_t length_;
};

template <typename Frame>
Frame anyFrame()
{
  Frame frame;
  Fields<Frame>::each(AnyValue(), frame);
  frame.time = *rc::gen::inRange(0, 1 << 30) / 379.0;  // usually no multiple of a nanosecond
  return frame;
}

/// A message after serialization and deserialization.
template <typename Message>
Message overTheWire(const Message& message)
{
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
  ros::serialization::IStream stream(bytes.message_start, bytes.num_bytes - 4);
  Message arrived;
  ros::serialization::deserialize(stream, arrived);
  return arrived;
}

TEST(Conversions, keepEveryBit)
{
  forEachFrameType(
      [](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        EXPECT_TRUE(rc::check(
            [=]
            {
              const auto frame = anyFrame<Frame>();
              RC_ASSERT(sameBits(toFrame(overTheWire(toMessage(frame))), frame));
            }))
            << describe(kindOf<Frame>()).name;
      });
}

/// The fields of a message, from its definition: without constants, comments and the header.
template <typename Message>
std::set<std::string> fieldsOfMessage()
{
  std::istringstream definition(ros::message_traits::definition<Message>());
  std::set<std::string> names;
  for (std::string line; std::getline(definition, line) && line.rfind("====", 0) != 0;)
  {
    line = line.substr(0, line.find('#'));
    std::istringstream words(line);
    std::string type, name;
    if (line.find('=') == std::string::npos && words >> type >> name && type != "Header")
      names.insert(name);
  }
  return names;
}

/// The fields of a described struct's message, from the description.
template <typename Struct>
std::set<std::string> describedFields()
{
  std::set<std::string> names;
  Struct object;
  const auto add = [&names](const FieldInfo& field, const auto& value)
  {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::vector<DiskState>> ||
                  std::is_same_v<Value, std::vector<SpeciesBins>>)
      names.merge(describedFields<typename Value::value_type>());
    else
      names.insert(field.name);
    if (IS_OPTIONAL<Value> || IS_OPTIONAL_LIST<Value>)
      names.insert(std::string(field.name) + "_defined");
  };
  Fields<Struct>::each(add, object);
  return names;
}

TEST(Conversions, leaveOutNoFieldOfAMessage)
{
  forEachFrameType(
      [](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        std::set<std::string> expected = describedFields<Frame>();
        if (std::is_same_v<Frame, StatisticsFrame>)
          expected.insert("collision_rate");  // the sum of the others
        EXPECT_EQ(fieldsOfMessage<MessageOf<Frame>>(), expected) << describe(kindOf<Frame>()).name;
      });
  EXPECT_EQ(fieldsOfMessage<SpeciesStatistics>(), describedFields<SpeciesRow>());
  EXPECT_EQ(fieldsOfMessage<Observation>(), describedFields<Observed>());
  EXPECT_EQ(fieldsOfMessage<ObservationRow>(), describedFields<ObservedRow>());
  EXPECT_EQ(fieldsOfMessage<ObservationNumber>(), describedFields<ObservedNumber>());
  EXPECT_EQ(fieldsOfMessage<ObservationColumn>(), describedFields<ObservedColumn>());
}

TEST(Conversions, stampInTheWorldFrame)
{
  BaseFrame frame;
  frame.time = 2.5;
  const BaseState message = toMessage(frame);
  EXPECT_EQ(message.header.stamp, ros::Time(2, 500000000));
  EXPECT_EQ(message.header.frame_id, "world");
  EXPECT_EQ(toMessage(frame, "s1/sieve_world").header.frame_id, "s1/sieve_world");
}

TEST(Conversions, sayUndefinedByAFlagAndZero)
{
  BinFrame frame;
  frame.processed = 0.25;
  const BinCounts message = toMessage(frame);
  EXPECT_FALSE(message.quality_defined);
  EXPECT_EQ(message.quality, 0.0);
  EXPECT_TRUE(message.processed_defined);
}

/// The radii take no room where every disk has that of its species.
TEST(Conversions, sendRadiiWhereDisksHaveTheirOwn)
{
  ParticleFrame frame;
  frame.disks.resize(2);
  frame.disks[1].id = 4;
  EXPECT_TRUE(toMessage(frame).radius.empty());
  EXPECT_TRUE(sameBits(toFrame(toMessage(frame)), frame));
  frame.disks[0].radius = 0.001;
  frame.disks[1].radius = 0.002;
  EXPECT_EQ(toMessage(frame).radius, (std::vector<double>{0.001, 0.002}));
  EXPECT_TRUE(sameBits(toFrame(toMessage(frame)), frame));
  ParticleStates wrong = toMessage(frame);
  wrong.radius.pop_back();
  EXPECT_THROW(toFrame(wrong), std::invalid_argument);
}

TEST(Conversions, refuseArraysOfDifferentLengths)
{
  ParticleStates particles;
  particles.id = {1, 2};
  EXPECT_THROW(toFrame(particles), std::invalid_argument);
  BinCounts bins;
  bins.left = {1};
  EXPECT_THROW(toFrame(bins), std::invalid_argument);
}
}  // namespace
}  // namespace ratchet_sieve
