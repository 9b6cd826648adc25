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

/// A saved state that cannot be: cut short, too long, or of another scene.
struct StateError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Takes a state apart into bytes or puts it together again, bit for bit, in the machine's own byte
/// order. A class says once what its state is, for both ways:
///
///     void archive(StateArchive& state) { state(position_, velocities_); }
class StateArchive
{
public:
  /// Saves.
  StateArchive() = default;

  /// Restores; the bytes outlive this.
  explicit StateArchive(std::string_view bytes) : restoring_(true), rest_(bytes) {}

  bool restoring() const { return restoring_; }

  /// What was saved.
  std::string takeBytes() { return std::move(saved_); }

  /// Saves or restores all of them, in order. @throws StateError where too few bytes are left
  template <typename... Values>
  void operator()(Values&... values)
  {
    (one(values), ...);
  }

  /// @throws StateError unless every byte was used
  void requireEnd() const
  {
    if (!rest_.empty())
      throw StateError("there is more of it than there should be");
  }

private:
  template <typename Value>
  static constexpr bool IS_PLAIN = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

  template <typename Value>
  void one(Value& value)
  {
    if constexpr (IS_PLAIN<Value>)
      bytes(&value, sizeof value);
    else
      value.archive(*this);
  }

  template <typename Element>
  void one(std::vector<Element>& list)
  {
    std::uint64_t size = list.size();
    one(size);
    // Every element takes a byte at least: a size that is not true cannot ask for more memory than that.
    constexpr std::size_t SMALLEST = IS_PLAIN<Element> ? sizeof(Element) : 1;
    if (restoring_ && size > rest_.size() / SMALLEST)
      throw StateError("it is cut short");
    list.resize(size);
    if constexpr (IS_PLAIN<Element>)
      bytes(list.data(), size * sizeof(Element));
    else
      for (Element& element : list)
        one(element);
  }

  template <typename Value>
  void one(std::optional<Value>& value)
  {
    std::uint8_t present = value ? 1 : 0;
    one(present);
    if (present == 0)
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

  void one(std::string& text)
  {
    std::uint64_t size = text.size();
    one(size);
    if (restoring_ && size > rest_.size())
      throw StateError("it is cut short");
    text.resize(size);
    bytes(text.data(), size);
  }

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
