#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/run.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/statistics/segregation.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "running_simulation.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds PROGRESS_PERIOD(100);

/// The frames of a run as Python's objects: lists of (time, disks), (time, base) and (time, bins), and those
/// of statistics and of what is observed, for the page.
class CollectedFrames : public FrameSink
{
public:
  explicit CollectedFrames(const SceneDefinition& scene) : scene_(scene) {}

  void take(const AnyFrame& frame) override
  {
    const py::gil_scoped_acquire held;
    if (const auto* particles = frame.as<ParticleFrame>())
      disks_.append(py::make_tuple(particles->time, arrayOf(particles->disks, scene_)));
    else if (const auto* base = frame.as<BaseFrame>())
      bases_.append(py::make_tuple(base->time, fieldsOf(base->base)));
    else if (const auto* bins = frame.as<BinFrame>())
      bins_.append(py::make_tuple(bins->time, fieldToPython(bins->bins)));
    else if (const auto* statistics = frame.as<StatisticsFrame>())
      others_.append(*statistics);
    else if (const auto* observed = frame.as<ObservedFrame>())
      others_.append(*observed);
  }

  py::dict lists() const
  {
    py::dict lists;
    lists["disks"] = disks_;
    lists["base"] = bases_;
    lists["bins"] = bins_;
    lists["others"] = others_;
    return lists;
  }

private:
  const SceneDefinition& scene_;
  py::list disks_;
  py::list bases_;
  py::list bins_;
  py::list others_;
};

/// Gives a simulation its threads while this exists. None outlives the run: a process that forks later, as
/// multiprocessing does, has none of them, and would wait for them without end.
class ThreadsOfRun
{
public:
  ThreadsOfRun(Simulation& simulation, std::size_t threads) : simulation_(simulation)
  {
    simulation.setThreads(threads);
  }
  ~ThreadsOfRun() { simulation_.setThreads(1); }
  ThreadsOfRun(const ThreadsOfRun&) = delete;
  ThreadsOfRun& operator=(const ThreadsOfRun&) = delete;

private:
  Simulation& simulation_;
};

/// Runs to the end of the scene.
/// @param frame_rate of frames [1/s of simulated time]; 0: none
/// @param progress called with the time, ten times a second; or None
py::tuple run(RunningSimulation& running, double frame_rate, bool collisions, std::size_t threads,
              const py::object& progress)
{
  RunningSimulation::Use simulation(running);
  SignalWatch signals;
  CollectedFrames frames(running.scene()->definition);
  // The observers' own: after an error they stay with the simulation.
  const auto records = std::make_shared<std::vector<CollisionRecord>>();
  const auto exits = std::make_shared<std::vector<ExitRecord>>();
  RunOutcome outcome;
  RunWatchers watchers;
  if (frame_rate > 0.0)
    watchers.frames = {{&frames, {frame_rate, frame_rate, frame_rate, FrameRates().statistics, 0.0}}};
  Clock::time_point next;
  if (!progress.is_none())
    watchers.progress = [&](const Simulation& now)
    {
      if (Clock::now() < next)
        return;
      next = Clock::now() + PROGRESS_PERIOD;
      signals.call(progress, now.time());
    };
  watchers.stop_wanted = [&] { return signals.stopWanted(); };
  {
    const py::gil_scoped_release let_go;
    const ThreadsOfRun of_run(*simulation, threads);
    if (collisions)
      simulation->observeCollisions([records](const CollisionRecord& record) { records->push_back(record); });
    simulation->observeExits([exits](const ExitRecord& record) { exits->push_back(record); });
    outcome = runToEnd(*simulation, watchers);
    simulation->observeCollisions({});
    simulation->observeExits({});
  }
  signals.raise();
  const nlohmann::ordered_json summary = summarize(*simulation, outcome);
  return py::make_tuple(toPython(summary), frames.lists(),
                        collisions ? py::object(arrayOf(*records)) : py::none(), arrayOf(*exits));
}

/// s of the best pair of species. @param counts of each species that which left on the left and on the right
std::optional<double> separation(const std::vector<std::pair<std::uint64_t, std::uint64_t>>& counts)
{
  std::vector<SpeciesBins> bins;
  bins.reserve(counts.size());
  for (const auto& [left, right] : counts)
    bins.push_back({left, right});
  return bestSeparation(bins).separation;
}

/// The columns of a case that was cut, as the results file would have them.
py::dict cutRow(const CaseResult& result)
{
  SummaryColumns columns = summaryColumns(result.summary);
  const SummaryColumns own = rowOf(result);
  columns.insert(columns.end(), own.begin(), own.end());
  py::dict row;
  for (const auto& [name, value] : columns)
    row[name.c_str()] = toPython(value);
  row["status"] = "cut";
  return row;
}

/// Runs the cases of a sweep that have no result in the file.
/// @param text of a sweep file @param progress called with the numbers of cases: done, failed, all; or None
/// @param seconds of wall time after which the cases under way are cut; or None
/// @return the sweep's fingerprint, by which the results file knows its cases, and a row for each that was
/// cut
py::tuple sweep(const std::string& text, const std::string& source, const std::string& results,
                std::size_t threads, const py::object& progress, const std::optional<double>& seconds)
{
  const Clock::time_point start = Clock::now();
  const Sweep sweep = sweepFromText(text, source);
  SignalWatch signals;
  std::atomic<bool> stop{false};
  const std::thread::id caller = std::this_thread::get_id();
  SweepRunOptions options;
  options.threads = threads;
  if (seconds)
    options.deadline =
        start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
  options.stop_wanted = [&]
  {
    if (std::this_thread::get_id() == caller && signals.stopWanted())
      stop = true;
    return stop.load();
  };
  if (!progress.is_none())
    options.progress = [&](const SweepProgress& now)
    { signals.call(progress, now.done, now.failed, now.cases); };
  SweepOutcome outcome;
  {
    const py::gil_scoped_release let_go;
    outcome = runSweep(sweep, results, options);
  }
  signals.raise();
  if (outcome.threads < outcome.threads_wanted)
    warnPython(fewerThreadsText(outcome.threads, outcome.threads_wanted));
  py::list cut;
  for (const CaseResult& result : outcome.cut)
    cut.append(cutRow(result));
  return py::make_tuple(sweep.fingerprint(), cut);
}

}  // namespace

void bindRun(py::module_& module)
{
  module.def("separation", &separation, py::arg("counts"));
  module.def("run", &run, py::arg("simulation"), py::arg("frame_rate"), py::arg("collisions"),
             py::arg("threads"), py::arg("progress"));
  module.def("sweep", &sweep, py::arg("text"), py::arg("source"), py::arg("results"), py::arg("threads"),
             py::arg("progress"), py::arg("seconds") = py::none());
  py::list kinds;
  for (const CollisionKind kind :
       {CollisionKind::DISK_DISK, CollisionKind::LEFT_SLOPE, CollisionKind::RIGHT_SLOPE, CollisionKind::APEX,
        CollisionKind::WALL, CollisionKind::LEVEL})
    kinds.append(name(kind));
  module.attr("COLLISION_KINDS") = py::tuple(kinds);
}

}  // namespace ratchet_sieve
