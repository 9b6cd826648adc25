#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "ratchet_sieve/recording/frames.h"

/// What frames consist of, once for all: comparison, conversion to messages and back, and checks go through
/// these fields. A new one is a line in its struct, a line here, and a line in the message.
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

// C++17 cannot list the members of a struct, nor have a name both as a member and as a text.
#define FIELDS_OF(STRUCT)                                           \
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
#define FIELD(NAME, UNIT) visit(FieldInfo{#NAME, UNIT}, objects.NAME...)

/// An optional number; in a message NAME and NAME_defined.
#define OPTIONAL(NAME, UNIT)                                                            \
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
#define PART(NAME)                                                                                   \
  Fields<decltype(Struct::NAME)>::each(                                                              \
      visit, [](auto& object) -> auto& {                                                             \
        if constexpr (std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(object)>>, \
                                     Struct>)                                                        \
          return object.NAME;                                                                        \
        else                                                                                         \
          return object;                                                                             \
      }(objects)...)

/// A vector of described structs; in a message an array for each of their fields.
#define COLUMNS(NAME)                                                        \
  visit(FieldInfo{#NAME, ""},                                                \
        [](auto& object) -> decltype(auto)                                   \
        {                                                                    \
          using Object = std::remove_reference_t<decltype(object)>;          \
          if constexpr (std::is_same_v<std::remove_const_t<Object>, Struct>) \
            return (object.NAME);                                            \
          else                                                               \
            return Columns<Object>{object};                                  \
        }(objects)...)

FIELDS_OF(SceneFrame)
{
  FIELD(time, "s");
  FIELD(start_time, "s");
  FIELD(yaml, "");
  FIELD(scene_hash, "");
  FIELD(seed, "");
  FIELD(version, "");
}

FIELDS_OF(CommandFrame)
{
  FIELD(time, "s");
  FIELD(kind, "");
  FIELD(values, "");
  FIELD(species, "");
  FIELD(count, "");
}

FIELDS_OF(DriveState)
{
  FIELD(inclination, "rad");
  FIELD(frequency, "Hz");
  FIELD(amplitude, "m");
  FIELD(commanded_inclination, "rad");
  FIELD(commanded_frequency, "Hz");
  FIELD(commanded_amplitude, "m");
  FIELD(phase, "rad");
  FIELD(displacement, "m");
  FIELD(velocity, "m/s");
}

FIELDS_OF(BaseFrame)
{
  FIELD(time, "s");
  PART(base);
}

FIELDS_OF(DiskState)
{
  FIELD(id, "");
  FIELD(species, "");
  FIELD(x, "m");
  FIELD(y, "m");
  FIELD(angle, "rad");
  FIELD(vx, "m/s");
  FIELD(vy, "m/s");
  FIELD(spin, "rad/s");
  FIELD(displacement, "m");
}

FIELDS_OF(ParticleFrame)
{
  FIELD(time, "s");
  COLUMNS(disks);
}

FIELDS_OF(SpeciesBins)
{
  FIELD(left, "");
  FIELD(right, "");
  FIELD(on_base, "");
}

FIELDS_OF(BinFrame)
{
  FIELD(time, "s");
  FIELD(species, "");
  COLUMNS(bins);
  OPTIONAL(quality, "");
  OPTIONAL(processed, "");
}

FIELDS_OF(SpeciesMeans)
{
  OPTIONAL(mean_vx, "m/s");
  OPTIONAL(mean_vx_stderr, "m/s");
  OPTIONAL(kinetic_translational, "J");
  OPTIONAL(kinetic_rotational, "J");
}

FIELDS_OF(SpeciesRow)
{
  FIELD(name, "");
  PART(means);
  OPTIONAL(granular_temperature, "J");
}

FIELDS_OF(CollisionCounts)
{
  FIELD(disk_disk, "");
  FIELD(left_slope, "");
  FIELD(right_slope, "");
  FIELD(apex, "");
  FIELD(wall, "");
}

FIELDS_OF(CollisionRates)
{
  FIELD(disk_disk_rate, "1/s");
  FIELD(left_slope_rate, "1/s");
  FIELD(right_slope_rate, "1/s");
  FIELD(apex_rate, "1/s");
  FIELD(wall_rate, "1/s");
}

FIELDS_OF(StatisticsFrame)
{
  FIELD(time, "s");
  FIELD(window_start, "s");
  FIELD(window_end, "s");
  FIELD(species, "");
  PART(collisions);
  FIELD(events, "");
  PART(collision_rates);
  FIELD(real_time_factor, "");
  FIELD(max_overlap, "m");
}

#undef FIELDS_OF
#undef FIELD
#undef OPTIONAL
#undef PART
#undef COLUMNS

}  // namespace ratchet_sieve
