#pragma once

#include <optional>
#include <type_traits>
#include <vector>

/// A list of a struct's fields, written once below the struct. Comparison, conversion to and from messages,
/// and checks use that list. A new field takes a line in its struct, a line in the list, and a line in the
/// message.
namespace ratchet_sieve
{

struct FieldInfo
{
  const char* name;     ///< of the member in the struct and in the message
  const char* unit;     ///< empty for fields that are no physical quantity
  bool sparse = false;  ///< whether its array in a message is empty if all values are 0
};

/// An optional number in a message: the value (0 if there is none) and a flag.
template <typename Number, typename Flag>
struct Flagged
{
  Number& value;
  Flag& defined;
};

/// A vector of structs in a message: one array for each field.
template <typename Message>
struct Columns
{
  Message& message;
};

/// The fields of a struct: `each(visit, object, others...)` calls visit(FieldInfo, of_object, of_others...)
/// for each field. The others may be messages. The field of a message is its member of the same name; a
/// Flagged for an optional number; a Columns for a vector that is stored as arrays.
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
constexpr bool IS_OPTIONAL_LIST = false;
template <typename T>
constexpr bool IS_OPTIONAL_LIST<std::vector<std::optional<T>>> = true;

template <typename T>
constexpr bool IS_VECTOR = false;
template <typename T>
constexpr bool IS_VECTOR<std::vector<T>> = true;

// Macros, because C++17 can neither list the members of a struct nor turn a member's name into text.

/// Begins the list of a struct. One of the macros below follows in braces for each member.
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

/// A member that the message has as well.
#define RATCHET_SIEVE_FIELD(NAME, UNIT) visit(FieldInfo{#NAME, UNIT}, objects.NAME...)

/// A number of a struct that is stored in arrays: an empty array if it is 0 in all of them.
#define RATCHET_SIEVE_SPARSE(NAME, UNIT) visit(FieldInfo{#NAME, UNIT, true}, objects.NAME...)

/// An optional number, or a list of them; NAME and NAME_defined in a message.
#define RATCHET_SIEVE_OPTIONAL(NAME, UNIT)                                                             \
  visit(FieldInfo{#NAME, UNIT},                                                                        \
        [](auto& object) -> decltype(auto)                                                             \
        {                                                                                              \
          if constexpr (IS_OPTIONAL<decltype(object.NAME)> || IS_OPTIONAL_LIST<decltype(object.NAME)>) \
            return (object.NAME);                                                                      \
          else                                                                                         \
            return Flagged<std::remove_reference_t<decltype((object.NAME))>,                           \
                           std::remove_reference_t<decltype((object.NAME##_defined))>>{                \
                object.NAME, object.NAME##_defined};                                                   \
        }(objects)...)

/// A described struct whose fields are fields of the message itself.
#define RATCHET_SIEVE_PART(NAME)                                                                     \
  Fields<decltype(Struct::NAME)>::each(                                                              \
      visit, [](auto& object) -> auto& {                                                             \
        if constexpr (std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(object)>>, \
                                     Struct>)                                                        \
          return object.NAME;                                                                        \
        else                                                                                         \
          return object;                                                                             \
      }(objects)...)

/// A vector of described structs; one array for each field in a message.
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
