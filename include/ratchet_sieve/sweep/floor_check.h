#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// Repeats a scene at a half and a quarter of its contact.min_rebound_speed, in this thread: a result that
/// depends on it is not the machine's. @param summary of the run at the scene's own value
/// @return `floor_check` of the summary: the results at each minimum rebound speed, the scene's own first,
/// and their differences from that one; null if stopped @pre the scene has a minimum rebound speed
nlohmann::ordered_json floorCheck(const SceneDefinition& scene, const nlohmann::ordered_json& summary,
                                  const std::function<bool()>& stop_wanted);

/// A table of what floorCheck() has found, and a line for each result: whether it depends on the minimum
/// rebound speed.
std::vector<std::string> floorCheckLines(const nlohmann::ordered_json& runs);

}  // namespace ratchet_sieve
