#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "running_simulation.h"

namespace ratchet_sieve
{

/// Advances each simulation to its time on several threads, with Python's lock let go. The results depend on
/// no number of threads.
/// @param threads 0: one per processor
/// @return which of them ended by a collapse
/// @throws what the handler of a signal raises; every simulation then stands at its time or an earlier one
std::vector<bool> advanceMany(const std::vector<std::shared_ptr<RunningSimulation>>& simulations,
                              const std::vector<double>& times, std::size_t threads);

}  // namespace ratchet_sieve
