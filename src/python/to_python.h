#pragma once

#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <yaml-cpp/yaml.h>
#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/core/simulation.h"

/// Values of the layers as Python's.
namespace ratchet_sieve
{

/// dict, list, int, float, bool, str; None for null.
pybind11::object toPython(const nlohmann::ordered_json& json);

/// A scene's YAML tree, likewise; its scalars are numbers where the scene's reader takes them for numbers.
/// @param is_name whether its scalars are names, which may look like numbers
pybind11::object toPython(const YAML::Node& node, bool is_name = false);

template <typename Struct>
pybind11::dict fieldsOf(const Struct& of);

/// A field of a struct: a described struct as a dict, a vector as a list, None for nothing.
template <typename Value>
pybind11::object fieldToPython(const Value& value)
{
  if constexpr (IS_DESCRIBED<Value>)
    return fieldsOf(value);
  else if constexpr (IS_VECTOR<Value>)
  {
    pybind11::list list;
    for (const auto& element : value)
      list.append(fieldToPython(element));
    return std::move(list);
  }
  else
    return pybind11::cast(value);
}

/// The fields of a struct by their names.
template <typename Struct>
pybind11::dict fieldsOf(const Struct& of)
{
  pybind11::dict fields;
  Fields<Struct>::each([&fields](const FieldInfo& field, const auto& value)
                       { fields[field.name] = fieldToPython(value); },
                       of);
  return fields;
}

template <typename Struct>
void setFields(Struct& of, const pybind11::dict& fields);

/// Sets what fieldToPython() has given.
template <typename Value>
void setField(Value& value, const pybind11::handle& from)
{
  if constexpr (IS_DESCRIBED<Value>)
    setFields(value, from.cast<pybind11::dict>());
  else if constexpr (IS_VECTOR<Value>)
    for (const pybind11::handle& element : from.cast<pybind11::list>())
      setField(value.emplace_back(), element);
  else
    value = from.cast<Value>();
}

/// Sets the fields of a struct, whose vectors are empty. @throws pybind11::key_error if one is missing
template <typename Struct>
void setFields(Struct& of, const pybind11::dict& fields)
{
  Fields<Struct>::each(
      [&fields](const FieldInfo& field, auto& value) { setField(value, fields[field.name]); }, of);
}

/// A new structured array of disks: id, species, radius, mass, x, y, vx, vy, angle, spin, displacement. SI.
/// @param scene for masses and for the radii that a frame leaves out
pybind11::array arrayOf(const std::vector<DiskState>& disks, const SceneDefinition& scene);

/// The disks of such an array. @throws std::invalid_argument if it is of another kind
std::vector<DiskState> disksOf(const pybind11::array& rows);

/// A new structured array of collisions: time, kind (its number in CollisionKind), i, j (-1: the base),
/// normal_speed, normal_impulse, tangential_impulse. SI.
pybind11::array arrayOf(const std::vector<CollisionRecord>& collisions);

/// A new structured array of disks that have left: time, id, species (its number), radius, mass, side (0:
/// left, 1: right), place. SI.
pybind11::array arrayOf(const std::vector<ExitRecord>& exits);

/// Registers the types of the elements of these arrays.
void describeArrays();

}  // namespace ratchet_sieve
