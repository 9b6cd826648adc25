#pragma once

#include <optional>
#include <type_traits>
#include <vector>

/// What a struct consists of, listed once, below the struct: comparison, conversion to messages and back, and
/// checks go through that list. A new field is a line in its struct, a line in the list, and a line in the
/// message.
namespace ratchet_sieve
{

struct FieldInfo
{
  const char* name;  ///< of the struct's member, and of the message's
  const char* unit;  ///< empty for what is no quantity
};

/// How an optional number stands in a message: a value, 0 where there is none, and a flag.
template <typename Number, typename Flag>
struct Flagged
{
  Number& value;
  Flag& defined;
};

/// How a vector of structs stands in a message: an array for each of their fields.
template <typename Message>
struct Columns
{
  Message& message;
};

/// The fields of a struct: `each(visit, object, others...)` calls visit(FieldInfo, of_object, of_others...)
/// for each of them, where the others may be messages: of a message a field is the member of that name, a
/// Flagged for an optional number, a Columns for a vector that is spread over arrays.
template <typename Struct>
struct Fields
{
  static constexpr bool DESCRIBED = false;
};

template <typename Struct>
constexpr bool IS_DESCRIBED = Fields<Struct>::DESCRIBED;

template <typename T>
constexpr bool IS_OPTIONAL = false;
template <typename T>
constexpr bool IS_OPTIONAL<std::optional<T>> = true;

template <typename T>
constexpr bool IS_VECTOR = false;
template <typename T>
constexpr bool IS_VECTOR<std::vector<T>> = true;

// C++17 cannot list the members of a struct, nor have a name both as a member and as a text. Hence macros.

/// Begins the list of a struct; in braces one of the lines below for each of its members.
#define RATCHET_SIEVE_FIELDS(STRUCT)                                \
  template <>                                                       \
  struct Fields<STRUCT>                                             \
  {                                                                 \
    using Struct = STRUCT;                                          \
    static constexpr bool DESCRIBED = true;                         \
    template <typename Visit, typename... Objects>                  \
    static constexpr void each(Visit&& visit, Objects&... objects); \
  };                                                                \
  template <typename Visit, typename... Objects>                    \
  constexpr void Fields<STRUCT>::each(Visit&& visit, Objects&... objects)

/// A member that a message has, too.
#define RATCHET_SIEVE_FIELD(NAME, UNIT) visit(FieldInfo{#NAME, UNIT}, objects.NAME...)

/// An optional number; in a message NAME and NAME_defined.
#define RATCHET_SIEVE_OPTIONAL(NAME, UNIT)                                              \
  visit(FieldInfo{#NAME, UNIT},                                                         \
        [](auto& object) -> decltype(auto)                                              \
        {                                                                               \
          if constexpr (IS_OPTIONAL<decltype(object.NAME)>)                             \
            return (object.NAME);                                                       \
          else                                                                          \
            return Flagged<std::remove_reference_t<decltype((object.NAME))>,            \
                           std::remove_reference_t<decltype((object.NAME##_defined))>>{ \
                object.NAME, object.NAME##_defined};                                    \
        }(objects)...)

/// A described struct whose fields a message has among its own.
#define RATCHET_SIEVE_PART(NAME)                                                                     \
  Fields<decltype(Struct::NAME)>::each(                                                              \
      visit, [](auto& object) -> auto& {                                                             \
        if constexpr (std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(object)>>, \
                                     Struct>)                                                        \
          return object.NAME;                                                                        \
        else                                                                                         \
          return object;                                                                             \
      }(objects)...)

/// A vector of described structs; in a message an array for each of their fields.
#define RATCHET_SIEVE_COLUMNS(NAME)                                          \
  visit(FieldInfo{#NAME, ""},                                                \
        [](auto& object) -> decltype(auto)                                   \
        {                                                                    \
          using Object = std::remove_reference_t<decltype(object)>;          \
          if constexpr (std::is_same_v<std::remove_const_t<Object>, Struct>) \
            return (object.NAME);                                            \
          else                                                               \
            return Columns<Object>{object};                                  \
        }(objects)...)

}  // namespace ratchet_sieve
