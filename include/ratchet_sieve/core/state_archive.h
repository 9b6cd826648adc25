#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace ratchet_sieve
{

/// An invalid saved state: damaged, too short, too long, or of another scene.
struct StateError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Converts a state into bytes and back, bit for bit, in the machine's own byte order. A class lists its
/// state once for both directions:
///
///     void archive(StateArchive& state) { state(position_, velocities_); }
class StateArchive
{
public:
  /// Saves.
  StateArchive() = default;

  /// Restores. @pre `bytes` outlives this object
  explicit StateArchive(std::string_view bytes) : restoring_(true), rest_(bytes) {}

  bool restoring() const { return restoring_; }

  /// The saved bytes.
  std::string takeBytes() { return std::move(saved_); }

  /// Saves or restores all values, in order. @throws StateError if too few bytes are left
  template <typename... Values>
  void operator()(Values&... values)
  {
    (one(values), ...);
  }

  /// @throws StateError unless every byte was used
  void requireEnd() const
  {
    if (!rest_.empty())
      throw StateError("it is too long");
  }

private:
  template <typename Value>
  static constexpr bool IS_PLAIN = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

  template <typename Value>
  void one(Value& value)
  {
    if constexpr (std::is_same_v<Value, bool>)
    {
      std::uint8_t byte = value ? 1 : 0;
      one(byte);
      value = byte != 0;
    }
    else if constexpr (std::is_same_v<Value, std::size_t> && sizeof(std::size_t) < sizeof(std::uint64_t))
    {
      // On 32-bit machines, such as WebAssembly, the bytes are those of a 64-bit one.
      std::uint64_t wide = value;
      one(wide);
      value = static_cast<std::size_t>(wide);
    }
    else if constexpr (IS_PLAIN<Value>)
      bytes(&value, sizeof value);
    else
      value.archive(*this);
  }

  template <typename Element, typename Allocator>
  void one(std::vector<Element, Allocator>& list)
  {
    // Every element takes at least one byte. So a corrupt size cannot request more memory than there are
    // bytes.
    resize(list, IS_PLAIN<Element> ? sizeof(Element) : 1);
    if constexpr (IS_PLAIN<Element>)
      bytes(list.data(), list.size() * sizeof(Element));
    else
      for (Element& element : list)
        one(element);
  }

  void one(std::string& text)
  {
    resize(text, 1);
    bytes(text.data(), text.size());
  }

  template <typename List>
  void resize(List& list, std::size_t bytes_per_element)
  {
    std::uint64_t size = list.size();
    one(size);
    if (restoring_ && size > rest_.size() / bytes_per_element)
      throw StateError("it is cut short");
    list.resize(size);
  }

  template <typename Value>
  void one(std::optional<Value>& value)
  {
    bool present = value.has_value();
    one(present);
    if (!present)
      return value.reset();
    if (!value)
      value.emplace();
    one(*value);
  }

  template <typename Element, std::size_t SIZE>
  void one(std::array<Element, SIZE>& list)
  {
    for (Element& element : list)
      one(element);
  }

  void one(Eigen::Vector2d& vector) { bytes(vector.data(), 2 * sizeof(double)); }

  void bytes(void* place, std::size_t count)
  {
    if (count == 0)
      return;
    if (!restoring_)
    {
      saved_.append(static_cast<const char*>(place), count);
      return;
    }
    if (count > rest_.size())
      throw StateError("it is cut short");
    std::memcpy(place, rest_.data(), count);
    rest_.remove_prefix(count);
  }

  bool restoring_ = false;
  std::string saved_;
  std::string_view rest_;
};

}  // namespace ratchet_sieve
