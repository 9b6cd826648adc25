#pragma once

#include <string>

#include "ratchet_sieve/core/plan.h"

/// What programs say of a scene before they run it, in one line each.
namespace ratchet_sieve
{

/// Which parts of the model are computed, which are not, and why.
std::string planText(const Plan& plan);

/// The number of disks, the height of their layer, the memory.
std::string sizeText(const SceneDefinition& scene);

}  // namespace ratchet_sieve
