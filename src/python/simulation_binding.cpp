#include <functional>
#include <memory>
#include <string>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/recording/checkpoint.h"
#include "ratchet_sieve/recording/summary.h"
#include "running_simulation.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

/// Calls `use` with the simulation. @param use a function of it or one of its own
template <typename Use>
auto read(Use use)
{
  return [use](RunningSimulation& running)
  {
    RunningSimulation::Use simulation(running);
    return std::invoke(use, *simulation);
  };
}

void advanceTo(RunningSimulation& running, double time)
{
  SignalWatch signals;
  {
    const py::gil_scoped_release let_go;
    running.advanceTo(time, [&signals] { return signals.stopWanted(); });
  }
  signals.raise();
}

void setSlewRates(RunningSimulation& running, double inclination, double frequency, double amplitude)
{
  running.setSlewRates({inclination, frequency, amplitude});
}

py::array disks(RunningSimulation& running)
{
  RunningSimulation::Use simulation(running);
  return arrayOf(simulation->disks(), running.scene()->definition);
}

py::bytes save(RunningSimulation& running)
{
  return saveRun(*RunningSimulation::Use(running));
}

std::shared_ptr<RunningSimulation> restore(const std::shared_ptr<Scene>& scene, const std::string& state)
{
  return std::make_shared<RunningSimulation>(scene, std::string_view(state));
}

/// What a summary says of a run so far. A part of it is known at the end of runToEnd() alone.
py::object summary(Simulation& simulation)
{
  nlohmann::ordered_json json = summarize(simulation, {});
  for (const char* of_whole_run : {"wall_time", "energy_start", "through_base", "warnings"})
    json.erase(of_whole_run);
  return toPython(json);
}

}  // namespace

void bindSimulation(py::module_& module)
{
  py::class_<RunningSimulation, std::shared_ptr<RunningSimulation>>(module, "Simulation")
      .def(py::init<std::shared_ptr<Scene>, double>(), py::arg("scene"), py::arg("start_time"))
      .def_static("restore", &restore, py::arg("scene"), py::arg("state"))
      .def("save", &save)
      .def("advance_to", &advanceTo, py::arg("time"))
      .def("command", &RunningSimulation::command, py::arg("setpoints"))
      .def("set_slew_rates", &setSlewRates, py::arg("inclination"), py::arg("frequency"),
           py::arg("amplitude"))
      .def("sense", &RunningSimulation::sense, py::arg("sensors"))
      .def("pour", &RunningSimulation::pour, py::arg("species"), py::arg("count"), py::arg("between"))
      .def("disks", &disks)
      .def("time", read(&Simulation::time))
      .def("active_disks", read(&Simulation::activeDisks))
      .def("events", read(&Simulation::events))
      .def("energy", read(&Simulation::energy))
      .def("base", read([](Simulation& simulation) { return fieldsOf(simulation.base()); }))
      .def("collisions", read([](Simulation& simulation) { return fieldsOf(simulation.collisions()); }))
      .def("bins", read([](Simulation& simulation) { return fieldToPython(simulation.bins()); }))
      .def("summary", read(&summary));
}

}  // namespace ratchet_sieve
