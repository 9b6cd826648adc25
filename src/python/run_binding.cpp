#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/core/segregation.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/run.h"
#include "ratchet_sieve/recording/summary.h"
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
    {
      py::list species;
      for (const SpeciesBins& of_species : bins->bins)
        species.append(fieldsOf(of_species));
      bins_.append(py::make_tuple(bins->time, species));
    }
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
  bool failed = false;
  Clock::time_point next;
  if (!progress.is_none())
    watchers.progress = [&](const Simulation& now)
    {
      if (failed || Clock::now() < next)
        return;
      next = Clock::now() + PROGRESS_PERIOD;
      const py::gil_scoped_acquire held;
      try
      {
        progress(now.time());
      }
      catch (py::error_already_set& error)
      {
        error.restore();
        failed = true;
      }
    };
  watchers.stop_wanted = [&] { return failed || signals.stopWanted(); };
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
  if (failed)
    throw py::error_already_set();
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

}  // namespace

void bindRun(py::module_& module)
{
  module.def("separation", &separation, py::arg("counts"));
  module.def("run", &run, py::arg("simulation"), py::arg("frame_rate"), py::arg("collisions"),
             py::arg("threads"), py::arg("progress"));
  py::list kinds;
  for (const CollisionKind kind :
       {CollisionKind::DISK_DISK, CollisionKind::LEFT_SLOPE, CollisionKind::RIGHT_SLOPE, CollisionKind::APEX,
        CollisionKind::WALL, CollisionKind::LEVEL})
    kinds.append(name(kind));
  module.attr("COLLISION_KINDS") = py::tuple(kinds);
}

}  // namespace ratchet_sieve
