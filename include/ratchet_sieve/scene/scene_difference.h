#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// The first key in which a scene differs from a saved one, and both values as text.
struct SceneDifference
{
  std::string key;  ///< dotted, such as species.0.radius
  std::string saved;
  std::string present;
};

/// @param saved, present texts of canonicalYaml() @throws SceneError one of them is no YAML
std::optional<SceneDifference> sceneDifference(const std::string& saved, const std::string& present);

}  // namespace ratchet_sieve
