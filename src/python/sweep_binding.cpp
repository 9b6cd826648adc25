#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>

#include <pybind11/pybind11.h>

#include "bindings.h"
#include "ratchet_sieve/sweep/sweep.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "running_simulation.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

/// Runs the cases of a sweep that have no result in the file.
/// @param text of a sweep file @param progress called with the numbers of cases: done, failed, all; or None
/// @return the sweep's fingerprint, by which the results file knows its cases
std::string sweep(const std::string& text, const std::string& source, const std::string& results,
                  std::size_t threads, const py::object& progress)
{
  const Sweep sweep = sweepFromText(text, source);
  SignalWatch signals;
  bool failed = false;
  std::atomic<bool> stop{false};
  const std::thread::id caller = std::this_thread::get_id();
  SweepRunOptions options;
  options.threads = threads;
  options.stop_wanted = [&]
  {
    if (std::this_thread::get_id() == caller && (failed || signals.stopWanted()))
      stop = true;
    return stop.load();
  };
  if (!progress.is_none())
    options.progress = [&](const SweepProgress& now)
    {
      if (failed)
        return;
      const py::gil_scoped_acquire held;
      try
      {
        progress(now.done, now.failed, now.cases);
      }
      catch (py::error_already_set& error)
      {
        error.restore();
        failed = true;
      }
    };
  SweepOutcome outcome;
  {
    const py::gil_scoped_release let_go;
    outcome = runSweep(sweep, results, options);
  }
  signals.raise();
  if (failed)
    throw py::error_already_set();
  if (outcome.threads < outcome.threads_wanted)
    warnPython(fewerThreadsText(outcome.threads, outcome.threads_wanted));
  return sweep.fingerprint();
}

}  // namespace

void bindSweep(py::module_& module)
{
  module.def("sweep", &sweep, py::arg("text"), py::arg("source"), py::arg("results"), py::arg("threads"),
             py::arg("progress"));
}

}  // namespace ratchet_sieve
