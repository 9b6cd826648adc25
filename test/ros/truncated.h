#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Float64.h>

namespace ratchet_sieve
{

/// Declares the type std_msgs/Float64, but has a length of three bytes.
struct Truncated
{
};

}  // namespace ratchet_sieve

namespace ros
{
namespace message_traits
{
template <>
struct MD5Sum<ratchet_sieve::Truncated>
{
  static const char* value() { return MD5Sum<std_msgs::Float64>::value(); }
  static const char* value(const ratchet_sieve::Truncated&) { return value(); }
};
template <>
struct DataType<ratchet_sieve::Truncated>
{
  static const char* value() { return DataType<std_msgs::Float64>::value(); }
  static const char* value(const ratchet_sieve::Truncated&) { return value(); }
};
template <>
struct Definition<ratchet_sieve::Truncated>
{
  static const char* value() { return Definition<std_msgs::Float64>::value(); }
  static const char* value(const ratchet_sieve::Truncated&) { return value(); }
};
}  // namespace message_traits

namespace serialization
{
template <>
struct Serializer<ratchet_sieve::Truncated>
{
  template <typename Stream>
  static void write(Stream& stream, const ratchet_sieve::Truncated&)
  {
    for (int k = 0; k < 3; ++k)
      stream.next(std::uint8_t{0x7f});
  }
  static std::uint32_t serializedLength(const ratchet_sieve::Truncated&) { return 3; }
};
}  // namespace serialization
}  // namespace ros
