#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// The first key whose value differs in two scenes, and both values as text.
struct SceneDifference
{
  std::string key;  ///< dotted, such as species.0.radius
  std::string one;
  std::string other;
};

/// @param one, other texts of canonicalYaml()
std::optional<SceneDifference> sceneDifference(const std::string& one, const std::string& other);

}  // namespace ratchet_sieve
