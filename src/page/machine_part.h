#pragma once

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// What the motion of the base and the outline of the machine follow from. SI units; undefined values are
/// null.
nlohmann::ordered_json machinePart(const SceneDefinition& scene);

}  // namespace ratchet_sieve
