#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <ros/serialization.h>

namespace ratchet_sieve
{

/// Reads a message as ros::serialization::IStream does, but allocates no memory for an array that is longer
/// than the message. ROS would resize it to any length given in the message.
class BoundedStream : public ros::serialization::Stream
{
public:
  // The name is required by roscpp's serialization. NOLINTNEXTLINE(readability-identifier-naming)
  static const ros::serialization::StreamType stream_type = ros::serialization::stream_types::Input;

  explicit BoundedStream(std::vector<std::uint8_t>& bytes)
      : Stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()))
  {
  }

  template <typename T>
  void next(T& value)
  {
    ros::serialization::deserialize(*this, value);
  }

  template <typename T, typename Allocator>
  void next(std::vector<T, Allocator>& array)
  {
    requireRoom(ros::serialization::serializationLength(T()));
    ros::serialization::deserialize(*this, array);
  }

  /// The check must come first: ROS moves the pointer beyond the end before it checks.
  std::uint8_t* advance(std::uint32_t length)
  {
    if (length > getLength())
      ros::serialization::throwStreamOverrun();
    return Stream::advance(length);
  }

private:
  /// @param element_size smallest size of an entry of the following array [bytes]
  void requireRoom(std::uint32_t element_size)
  {
    BoundedStream ahead = *this;
    std::uint32_t length;
    ahead.next(length);
    if (length > ahead.getLength() / element_size)
      throw std::invalid_argument("a message names an array of " + std::to_string(length) +
                                  " entries but is shorter");
  }
};

}  // namespace ratchet_sieve
