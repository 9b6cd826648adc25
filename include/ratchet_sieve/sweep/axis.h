#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ratchet_sieve/scene/entry.h"

namespace ratchet_sieve
{

/// A key of the scene, as a dotted path, and its new value, as YAML text on one line.
struct Assignment
{
  std::string key;
  std::string value;
};

/// The values of one key: a list, or a range whose values are computed on demand.
struct SweptValues
{
  std::uint64_t count = 0;
  std::function<std::string(std::uint64_t)> at;  ///< YAML text
};

/// One factor of a sweep's product of values.
struct Axis
{
  std::vector<std::string> keys;
  std::uint64_t size = 0;
  std::function<std::vector<Assignment>(std::uint64_t)> at;  ///< the assignments of one step along the axis
  std::string text;                                          ///< its source text, on one line
};

/// A node's YAML text on one line; parsing it gives the same node. @pre the node does not contain itself
std::string flowText(const YAML::Node& node);

/// `from + (to - from) k / (count - 1)`, rounded to 15 digits: 0.3 stays 0.3, and a coarser range has exactly
/// the values of a finer one where they coincide. @pre k < count
double rangeValue(double from, double to, std::uint64_t count, std::uint64_t k);

/// Reads `[..]` or `{from: .., to: .., count: ..}`. @throws SceneError, also for an empty list
SweptValues readValues(const Entry& entry);

/// `KEY: VALUES`, all values of one key.
Axis readGridAxis(const Entry& grid, const std::string& key);

/// `{KEY: VALUES, ...}`, the lists stepped through together. @throws SceneError if their lengths differ
Axis readZip(const Entry& zip);

/// `[{KEY: VALUE, ...}, ...]`, one after the other. @throws SceneError if empty
Axis readCases(const Entry& cases);

/// `{KEY: VALUE, ...}`.
std::vector<Assignment> readAssignments(const Entry& map);

}  // namespace ratchet_sieve
