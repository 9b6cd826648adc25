#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ratchet_sieve/scene/entry.h"

namespace ratchet_sieve
{

/// A key of the scene, as a dotted path, and the value that it gets, as YAML text on one line.
struct Assignment
{
  std::string key;
  std::string value;
};

/// The values of one key: a list, or a range of which none is kept.
struct SweptValues
{
  std::uint64_t count = 0;
  std::function<std::string(std::uint64_t)> at;  ///< YAML text
};

/// One factor of the product that a sweep is.
struct Axis
{
  std::vector<std::string> keys;
  std::uint64_t size = 0;
  std::function<std::vector<Assignment>(std::uint64_t)> at;  ///< what one step along it sets
  std::string text;                                          ///< what it was read from, on one line
};

/// A node's YAML text on one line, which reads back to the same. @pre no part of it holds itself
std::string flowText(const YAML::Node& node);

/// `from + (to - from) k / (count - 1)`, rounded to 15 digits, so that 0.3 is 0.3 and a finer range has
/// every value of a coarser one that it holds. @pre k < count
double rangeValue(double from, double to, std::uint64_t count, std::uint64_t k);

/// Reads `[..]` or `{from: .., to: .., count: ..}`. @throws SceneError, where there is no value as well
SweptValues readValues(const Entry& entry);

/// `KEY: VALUES`, all values of one key.
Axis readGridAxis(const Entry& grid, const std::string& key);

/// `{KEY: VALUES, ...}` side by side. @throws SceneError where they are not equally many
Axis readZip(const Entry& zip);

/// `[{KEY: VALUE, ...}, ...]`, one by one. @throws SceneError where there is none
Axis readCases(const Entry& cases);

/// `{KEY: VALUE, ...}`.
std::vector<Assignment> readAssignments(const Entry& map);

}  // namespace ratchet_sieve
