#pragma once

#include <optional>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/fields.h"

namespace nlohmann
{

/// What is undefined is null.
template <typename T>
struct adl_serializer<std::optional<T>>
{
  template <typename Json>
  static void to_json(Json& json, const std::optional<T>& value)
  {
    json = value ? Json(*value) : Json(nullptr);
  }
};

/// A described struct is an object of its fields.
template <typename T>
struct adl_serializer<T, std::enable_if_t<ratchet_sieve::IS_DESCRIBED<T>>>
{
  template <typename Json>
  static void to_json(Json& json, const T& of)
  {
    ratchet_sieve::Fields<T>::each(
        [&json](const ratchet_sieve::FieldInfo& field, const auto& value) { json[field.name] = value; }, of);
  }
};

}  // namespace nlohmann
