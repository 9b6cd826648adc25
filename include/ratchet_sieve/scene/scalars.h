#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/scene/entry.h"

/// Reads values strictly: text is not a number, a number is not a truth value, and an integer has no
/// fraction.
namespace ratchet_sieve
{

/// The values that a number may have: between two bounds, both included, or any.
struct Range
{
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  const char* unit = "";

  bool isBounded() const { return std::isfinite(lowest) && std::isfinite(highest); }
  bool holds(double value) const { return value >= lowest && value <= highest; }

  /// Such as "0 to 1000", or "any".
  std::string values() const;

  /// Such as "from 0 to 1000 m", or "that is finite".
  std::string text() const;
};

/// Longest name of a species [characters].
constexpr std::size_t LONGEST_NAME = 64;

/// Most corners of a profile.
constexpr std::size_t MOST_CORNERS = 10000;

struct FilePath
{
  std::string text;
};

/// The side at which disks left the machine before.
enum class FeedSide
{
  LEFT,
  RIGHT,
  BOTH  ///< has no name in a scene
};

/// All throw SceneError, which names the value and what is allowed.
void readScalar(const Entry& entry, const Range& range, double& value);
void readScalar(const Entry& entry, const Range& range, int& value);
void readScalar(const Entry& entry, const Range& range, std::uint64_t& value);
void readScalar(const Entry& entry, const Range& range, bool& value);
void readScalar(const Entry& entry, const Range& range, std::string& value);
void readScalar(const Entry& entry, const Range& range, FilePath& value);
void readScalar(const Entry& entry, const Range& range, std::vector<double>& values);  ///< each in the range
/// The outline of a tooth, without overhang. @param range of each number
void readScalar(const Entry& entry, const Range& range, std::vector<OutlineCorner>& value);

/// Names of observables, each once.
void readScalar(const Entry& entry, const Range& range, std::vector<std::string>& value);

/// The text that the readers above take back to the same value, bit for bit.
std::string scalarText(double value);
std::string scalarText(bool value);
std::string scalarText(const std::string& value);
std::string scalarText(const FilePath& value);
std::string scalarText(const OutlineCorner& value);
std::string scalarText(const std::vector<std::string>& words);  ///< without quotes

/// The names of a choice's values in a scene, in the order of the enumeration.
template <typename Choice>
constexpr std::array<const char*, 0> CHOICE_NAMES = {};
template <>
inline constexpr std::array<const char*, 3> CHOICE_NAMES<Boundary> = {"periodic", "open", "walled"};
template <>
inline constexpr std::array<const char*, 2> CHOICE_NAMES<DriveFrame> = {"world", "base"};
template <>
inline constexpr std::array<const char*, 2> CHOICE_NAMES<CollapseAction> = {"stop", "rebound"};
template <>
inline constexpr std::array<const char*, 2> CHOICE_NAMES<ChokeAction> = {"run", "stop"};
template <>
inline constexpr std::array<const char*, 2> CHOICE_NAMES<FeedSide> = {"left", "right"};
template <>
inline constexpr std::array<const char*, 2> CHOICE_NAMES<Method> = {"events", "steps"};
template <>
inline constexpr std::array<const char*, 4> CHOICE_NAMES<SizeDistribution> = {"uniform", "normal",
                                                                              "lognormal", "table"};
template <>
inline constexpr std::array<const char*, 2> CHOICE_NAMES<SizeShare> = {"number", "mass"};

template <typename Choice>
using IfChoice = std::enable_if_t<std::is_enum_v<Choice>>;

template <typename Integer>
std::enable_if_t<std::is_integral_v<Integer>, std::string> scalarText(Integer value)
{
  return std::to_string(value);
}

template <typename Choice, typename = IfChoice<Choice>>
std::string scalarText(Choice value)
{
  return CHOICE_NAMES<Choice>[static_cast<std::size_t>(value)];
}

template <typename Element>
std::string scalarText(const std::vector<Element>& values)
{
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const Element& value : values)
    texts.push_back(scalarText(value));
  return scalarText(texts);
}

/// The words, separated by commas, but the last two by `last`.
std::string listText(const std::vector<std::string>& words, const char* last = ", ");

/// What the reader of a type accepts.
struct LegalValues
{
  const char* type;    ///< number, integer, boolean, name, path, choice or list
  std::string values;  ///< such as "0 to 1000" or "stop or rebound"
};

template <typename T>
LegalValues legalValues(const Range& range)
{
  if constexpr (std::is_enum_v<T>)
    return {"choice", listText({CHOICE_NAMES<T>.begin(), CHOICE_NAMES<T>.end()}, " or ")};
  else if constexpr (std::is_same_v<T, bool>)
    return {"boolean", "true or false"};
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return {"integer", "0 to " + std::to_string(std::numeric_limits<T>::max())};
  else if constexpr (std::is_same_v<T, std::string>)
    return {"name", "1 to " + std::to_string(LONGEST_NAME) + " letters, digits, '_', '-' or '.'"};
  else if constexpr (std::is_same_v<T, FilePath>)
    return {"path", "path of a file"};
  else if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return {"list", listText(observableNames())};
  else if constexpr (std::is_same_v<T, std::vector<OutlineCorner>>)
    return {"list",
            "2 to " + std::to_string(MOST_CORNERS) + " corners [s, n], each number " + range.values()};
  else if constexpr (std::is_same_v<T, int>)
    return {"integer", range.values()};
  else if constexpr (std::is_same_v<T, double>)
    return {"number", range.values()};
  else
    return {"list", range.values()};
}

template <typename Choice, typename = IfChoice<Choice>>
void readScalar(const Entry& entry, const Range& range, Choice& value)
{
  for (std::size_t i = 0; i < CHOICE_NAMES<Choice>.size(); ++i)
    if (entry.node().IsScalar() && entry.node().Scalar() == CHOICE_NAMES<Choice>[i])
    {
      value = static_cast<Choice>(i);
      return;
    }
  entry.refuseValue("must be " + legalValues<Choice>(range).values);
}

}  // namespace ratchet_sieve
