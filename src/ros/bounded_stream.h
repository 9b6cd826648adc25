#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <ros/serialization.h>

namespace ratchet_sieve
{

/// Reads a message as ros::serialization::IStream does, but claims no memory for an array that the
/// message is too short to hold: ROS resizes to whatever length the message names.
class BoundedStream : public ros::serialization::Stream
{
public:
  // The name is what roscpp's serialization asks for. NOLINTNEXTLINE(readability-identifier-naming)
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

  /// ROS steps beyond the end before it checks where that is.
  std::uint8_t* advance(std::uint32_t length)
  {
    if (length > getLength())
      ros::serialization::throwStreamOverrun();
    return Stream::advance(length);
  }

private:
  /// @param element_size the least that an entry of the array that follows takes [bytes]
  void requireRoom(std::uint32_t element_size)
  {
    BoundedStream ahead = *this;
    std::uint32_t length;
    ahead.next(length);
    if (length > ahead.getLength() / element_size)
      throw std::invalid_argument("a message names an array of " + std::to_string(length) +
                                  " entries and ends before");
  }
};

}  // namespace ratchet_sieve
