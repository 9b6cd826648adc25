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

/// What a reader above accepts.
struct LegalValues
{
  const char* type;    ///< number, integer, boolean, name, path, choice or list
  std::string values;  ///< such as "0 to 1000" or "stop or rebound"
};

/// The argument is given for its type alone.
LegalValues legalValues(const Range& range, double);
LegalValues legalValues(const Range& range, int);
LegalValues legalValues(const Range& range, std::uint64_t);
LegalValues legalValues(const Range& range, bool);
LegalValues legalValues(const Range& range, const std::string&);
LegalValues legalValues(const Range& range, const FilePath&);
LegalValues legalValues(const Range& range, const std::vector<std::string>&);
LegalValues legalValues(const Range& range, const std::vector<double>&);
LegalValues legalValues(const Range& range, const std::vector<OutlineCorner>&);

/// The text that the readers above take back to the same value, bit for bit.
std::string scalarText(double value);
std::string scalarText(bool value);
std::string scalarText(const std::string& value);
std::string scalarText(const FilePath& value);
std::string scalarText(const std::vector<std::string>& value);
std::string scalarText(const std::vector<double>& values);
std::string scalarText(const std::vector<OutlineCorner>& value);

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

template <typename Choice, typename = IfChoice<Choice>>
LegalValues legalValues(const Range&, Choice)
{
  std::string names;
  for (std::size_t i = 0; i < CHOICE_NAMES<Choice>.size(); ++i)
    names += (i == 0                                ? ""
              : i + 1 < CHOICE_NAMES<Choice>.size() ? ", "
                                                    : " or ") +
             std::string(CHOICE_NAMES<Choice>[i]);
  return {"choice", names};
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
  entry.refuseValue("must be " + legalValues(range, value).values);
}

}  // namespace ratchet_sieve
