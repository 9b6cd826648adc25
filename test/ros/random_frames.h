#pragma once

#include <rapidcheck.h>

#include "ratchet_sieve/core/fields.h"

/// Frames of arbitrary content, for properties that hold for any run.
namespace ratchet_sieve
{

/// From 0 to a month, usually no multiple of a nanosecond.
inline double anyTime()
{
  return *rc::gen::inRange(0, 1 << 30) / 379.0;
}

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
  frame.time = anyTime();
  return frame;
}

}  // namespace ratchet_sieve
