#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

/// Estimated duration of all cases, measured by running the first for at most a second: `about 3 days`, or
/// the reason why it is unknown.
std::string estimateText(const Sweep& sweep, std::size_t threads);

/// The estimated processor time of all cases, then a line for each corner of the grid, where the keys have
/// their first or last values. From a run of at most half a second of each corner, of at most 16: from the
/// fifth axis on, axes go to their ends together with an earlier one.
/// @throws SceneError for an illegal case
std::vector<std::string> costLines(const Sweep& sweep);

}  // namespace ratchet_sieve
