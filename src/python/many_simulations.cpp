#include "many_simulations.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>

#include <pybind11/pybind11.h>

#include "errors.h"
#include "ratchet_sieve/sweep/sweep_run.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

/// The work of all threads: each takes the next simulation until none is left.
struct Work
{
  std::size_t count;
  const SimulationJob& job;
  std::vector<char> stalled;  ///< written by several threads, so no vector of bits
  std::vector<std::exception_ptr> errors;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};

  void run(const std::function<bool()>& stop_wanted)
  {
    for (std::size_t k = next++; k < count; k = next++)
    {
      try
      {
        job(k, [&] { return stop || stop_wanted(); });
      }
      catch (const StallError&)
      {
        stalled[k] = 1;
      }
      catch (...)
      {
        errors[k] = std::current_exception();
        stop = true;
      }
    }
  }
};

}  // namespace

std::vector<bool> withMany(const std::vector<std::shared_ptr<RunningSimulation>>& simulations,
                           std::size_t threads, const SimulationJob& job)
{
  const std::size_t count = simulations.size();
  if (std::set<std::shared_ptr<RunningSimulation>>(simulations.begin(), simulations.end()).size() != count)
    throw std::invalid_argument("a simulation is given twice");
  if (threads == 0)
    threads = std::max(1u, std::thread::hardware_concurrency());
  Work work{count, job, std::vector<char>(count), std::vector<std::exception_ptr>(count)};
  threads = std::min(threads, count);
  SignalWatch signals;
  std::vector<std::thread> others;
  {
    const py::gil_scoped_release let_go;
    try
    {
      for (std::size_t k = 1; k < threads; ++k)
        others.emplace_back([&work] { work.run([] { return false; }); });
    }
    catch (const std::system_error&)
    {
      // The system provides no more; there is a warning at the end.
    }
    // This thread serves the signals.
    work.run(
        [&]
        {
          if (signals.stopWanted())
            work.stop = true;
          return work.stop.load();
        });
    for (std::thread& other : others)
      other.join();
  }
  signals.raise();
  for (const std::exception_ptr& error : work.errors)
    if (error)
      std::rethrow_exception(error);
  if (others.size() + 1 < threads)
    warnPython(fewerThreadsText(others.size() + 1, threads));
  return {work.stalled.begin(), work.stalled.end()};
}

std::vector<bool> advanceMany(const std::vector<std::shared_ptr<RunningSimulation>>& simulations,
                              const std::vector<double>& times, std::size_t threads)
{
  if (times.size() != simulations.size())
    throw std::invalid_argument("there must be one time for each simulation");
  return withMany(simulations, threads,
                  [&](std::size_t k, const std::function<bool()>& stop_wanted)
                  { simulations[k]->advanceTo(times[k], stop_wanted); });
}

}  // namespace ratchet_sieve
