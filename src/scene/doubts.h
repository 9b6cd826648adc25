#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/scene/scalars.h"

/// How a doubt about a scene is put: see implausibilities().
namespace ratchet_sieve
{

/// A figure, to four digits; in whole numbers where it has more.
inline std::string number(double value)
{
  std::ostringstream out;
  const bool whole = std::abs(value) >= 1e4 && std::abs(value) < 1e9;
  out.precision(whole ? 0 : 4);
  if (whole)
    out << std::fixed;
  out << value;
  return out.str();
}

inline std::string quantity(double value, const char* unit)
{
  return number(value) + " " + unit;
}

/// The lines, and how one is put.
class Doubts
{
public:
  /// "KEY = VALUE UNIT: FIGURE; meant MEANT UNIT?"
  void add(const std::string& key, double value, const char* unit, const std::string& figure,
           const std::optional<double>& meant = std::nullopt)
  {
    std::string line = key + " = " + scalarText(value) + " " + unit + ": " + figure;
    if (meant)
      line += "; meant " + quantity(*meant, unit) + "?";
    lines_.push_back(line);
  }

  void add(const std::string& line) { lines_.push_back(line); }

  std::size_t size() const { return lines_.size(); }

  std::vector<std::string> take() { return std::move(lines_); }

private:
  std::vector<std::string> lines_;
};

/// What a value is where its unit was mistaken by this factor, if that is plausible.
template <typename Plausible>
std::optional<double> meant(double value, double factor, Plausible&& plausible)
{
  return plausible(value * factor) ? std::optional(value * factor) : std::nullopt;
}

/// About accuracy.method and accuracy.step.
/// @param speed of the fastest disks, without a collision [m/s]
void doubtSteps(const SceneDefinition& scene, double speed, Doubts& doubts);

}  // namespace ratchet_sieve
