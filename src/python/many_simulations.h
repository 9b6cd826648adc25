#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "running_simulation.h"

namespace ratchet_sieve
{

/// What is done with one of many simulations, by its number. Asks often whether to stop. @throws StallError
using SimulationJob = std::function<void(std::size_t k, const std::function<bool()>& stop_wanted)>;

/// Does a job with each simulation on several threads, with Python's lock let go. The results depend on no
/// number of threads.
/// @param threads 0: one per processor
/// @return which of them ended by a collapse
/// @throws std::invalid_argument if a simulation is given twice; what a job throws; what the handler of a
/// signal raises, after all jobs have stopped
std::vector<bool> withMany(const std::vector<std::shared_ptr<RunningSimulation>>& simulations,
                           std::size_t threads, const SimulationJob& job);

/// Advances each simulation to its time.
/// @throws what the handler of a signal raises; every simulation then stands at its time or an earlier one
std::vector<bool> advanceMany(const std::vector<std::shared_ptr<RunningSimulation>>& simulations,
                              const std::vector<double>& times, std::size_t threads);

}  // namespace ratchet_sieve
