#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <future>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "running_simulation.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using StopWanted = std::function<bool()>;

/// The names of a struct's fields.
template <typename Struct>
std::vector<std::string> fieldNames()
{
  std::vector<std::string> names;
  const Struct any;
  Fields<Struct>::each([&names](const FieldInfo& field, const auto&) { names.emplace_back(field.name); },
                       any);
  return names;
}

/// Writes the fields of a struct, one after the other. @return the place after the last one
template <typename Struct>
double* writeFields(const Struct& of, double* to)
{
  Fields<Struct>::each([&to](const FieldInfo&, const auto& value) { *to++ = static_cast<double>(value); },
                       of);
  return to;
}

/// The numbers of disks of each species in equal cells along the base; what is beyond an end counts in the
/// cell at that end.
void writeHistogram(const std::vector<DiskState>& disks, const DriveState& base, double width,
                    std::size_t cells, double* to)
{
  const auto last = static_cast<double>(cells - 1);
  for (const DiskState& disk : disks)
  {
    const double place = placeAlong(base, disk) / width * static_cast<double>(cells);
    const double cell = std::clamp(std::floor(place), 0.0, last);
    to[disk.species * cells + static_cast<std::size_t>(cell)] += 1.0;
  }
}

/// The mean velocities of the disks of each species that were in the machine during all of a step; not a
/// number where there is none. Both lists are in the order of ids.
void writeVelocities(const std::vector<DiskState>& before, const std::vector<DiskState>& after,
                     double elapsed, std::size_t species, double* to)
{
  std::vector<double> paths(species);
  std::vector<std::size_t> counts(species);
  auto old = before.begin();
  for (const DiskState& disk : after)
  {
    while (old != before.end() && old->id < disk.id)
      ++old;
    if (old == before.end() || old->id != disk.id)
      continue;
    paths[disk.species] += disk.displacement - old->displacement;
    ++counts[disk.species];
  }
  for (std::size_t k = 0; k < species; ++k)
    to[k] = counts[k] > 0 && elapsed > 0.0 ? paths[k] / (static_cast<double>(counts[k]) * elapsed)
                                           : std::numeric_limits<double>::quiet_NaN();
}

/// A table of zeros. It is filled without Python's lock.
Doubles table(const std::vector<std::size_t>& shape)
{
  Doubles zeros(shape);
  std::fill_n(zeros.mutable_data(), zeros.size(), 0.0);
  return zeros;
}

/// What is read of each simulation at the end of a step.
struct Readings
{
  Readings(std::size_t rows, std::size_t species_count, std::size_t cell_count, std::size_t sensed)
      : species(species_count),
        cells(cell_count),
        time(table({rows})),
        bins(table({rows, species, fieldNames<SpeciesBins>().size()})),
        base(table({rows, fieldNames<DriveState>().size()})),
        mean_vx(table({rows, species})),
        histogram(table({rows, species, cells})),
        sensors(table({rows, sensed}))
  {
  }

  /// Commands a simulation, advances it and reads it into a row. @return the text of the collapse that ended
  /// it, or none
  std::string step(std::size_t row, RunningSimulation& running, const std::map<std::string, double>& command,
                   double until, const StopWanted& stop_wanted)
  {
    running.command(command);
    const double start = RunningSimulation::Use(running)->time();
    const std::vector<DiskState> before = RunningSimulation::Use(running)->disks();
    std::string collapse;
    try
    {
      running.advanceTo(until, stop_wanted);
    }
    catch (const StallError& error)
    {
      collapse = error.what();
    }
    RunningSimulation::Use simulation(running);
    const std::vector<DiskState> disks = simulation->disks();
    const DriveState drive = simulation->base();
    *time.mutable_data(row) = simulation->time();
    double* to = bins.mutable_data(row);
    for (const SpeciesBins& of_species : simulation->bins())
      to = writeFields(of_species, to);
    writeFields(drive, base.mutable_data(row));
    writeVelocities(before, disks, simulation->time() - start, species, mean_vx.mutable_data(row));
    writeHistogram(disks, drive, simulation->scene().base.width(), cells, histogram.mutable_data(row));
    const std::vector<double> sensed = running.sensed();
    std::copy(sensed.begin(), sensed.end(), sensors.mutable_data(row));
    return collapse;
  }

  std::size_t species;
  std::size_t cells;
  Doubles time, bins, base, mean_vx, histogram, sensors;  ///< with a row for each simulation
};

/// Does a job for each k below `count` on several threads, each of which takes the next one until none is
/// left, with Python's lock let go. A job asks often whether to stop.
/// @param threads 0: one per processor
/// @throws what a job throws; what the handler of a signal raises, after all jobs have stopped
void shareOut(std::size_t count, std::size_t threads,
              const std::function<void(std::size_t k, const StopWanted& stop_wanted)>& job)
{
  threads = std::min(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()), count);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  const auto work = [&](const StopWanted& stop_wanted)
  {
    try
    {
      for (std::size_t k = next++; k < count; k = next++)
        job(k, stop_wanted);
    }
    catch (...)
    {
      stop = true;
      throw;
    }
  };
  SignalWatch signals;
  const auto serve = [&]
  {
    if (signals.stopWanted())
      stop = true;
    return stop.load();
  };
  std::vector<std::future<void>> shares;
  shares.push_back(
      std::async(std::launch::deferred, work, serve));  // of this thread, which serves the signals
  {
    const py::gil_scoped_release let_go;
    try
    {
      while (shares.size() < threads)
        shares.push_back(std::async(std::launch::async, work, [&] { return stop.load(); }));
    }
    catch (const std::system_error&)
    {
      // The system provides no more; there is a warning at the end.
    }
    for (const std::future<void>& share : shares)
      share.wait();
  }
  signals.raise();
  for (std::future<void>& share : shares)
    share.get();
  if (shares.size() < threads)
    warnPython(fewerThreadsText(shares.size(), threads));
}

/// Commands each simulation its setpoints, advances it to its time, and reads it, on several threads.
/// @param names of the commanded quantities @param setpoints a row for each simulation, a column for each
/// name @param cells of the histograms along the base, at least one
/// @return columns of Readings; of each simulation the text of the collapse that ended it, or None
py::tuple stepMany(const std::vector<std::shared_ptr<RunningSimulation>>& simulations,
                   const std::vector<std::string>& names, const Doubles& setpoints,
                   const std::vector<double>& times, std::size_t cells, std::size_t threads)
{
  const std::size_t count = simulations.size();
  if (count == 0 || times.size() != count || cells == 0 ||
      static_cast<std::size_t>(setpoints.size()) != count * names.size())
    throw std::invalid_argument("there must be one time and one row of setpoints for each simulation");
  std::vector<std::map<std::string, double>> commands(count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t q = 0; q < names.size(); ++q)
      commands[k][names[q]] = setpoints.data()[k * names.size() + q];
  const RunningSimulation& first = *simulations.front();
  Readings readings(count, first.scene()->definition.species.size(), cells, first.sensed().size());
  std::vector<std::string> collapses(count);
  shareOut(count, threads,
           [&](std::size_t k, const StopWanted& stop_wanted)
           { collapses[k] = readings.step(k, *simulations[k], commands[k], times[k], stop_wanted); });
  py::list texts;
  for (const std::string& text : collapses)
    texts.append(text.empty() ? py::object(py::none()) : py::str(text));
  py::dict columns;
  columns["time"] = readings.time;
  columns["bins"] = readings.bins;
  columns["base"] = readings.base;
  columns["mean_vx"] = readings.mean_vx;
  columns["histogram"] = readings.histogram;
  columns["sensors"] = readings.sensors;
  return py::make_tuple(columns, texts);
}

py::tuple rangeOf(const Interval& interval)
{
  return py::make_tuple(interval.min, interval.max);
}

}  // namespace

void bindControl(py::module_& module)
{
  py::list quantities;
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
  {
    py::dict of;
    of["name"] = quantity.name;
    of["unit"] = quantity.unit;
    of["legal"] = rangeOf(quantity.legal);
    of["usual"] = rangeOf(quantity.usual);
    of["slew_rate"] = SlewRates().*quantity.slew_rate;
    of["slew_rates"] = rangeOf(quantity.slew_rates);
    quantities.append(of);
  }
  module.attr("COMMANDED_QUANTITIES") = py::tuple(quantities);
  module.attr("BIN_FIELDS") = py::tuple(py::cast(fieldNames<SpeciesBins>()));
  module.attr("DISK_FIELDS") = py::tuple(py::cast(fieldNames<DiskState>()));
  module.attr("BASE_FIELDS") = py::tuple(py::cast(fieldNames<DriveState>()));
  module.def(
      "sensed_names",
      [](const std::string& sensors, const std::shared_ptr<Scene>& scene)
      {
        std::vector<std::string> names;
        for (const Sensor& sensor : sensorsFromText(sensors, scene->definition, 0.0))
          names.insert(names.end(), sensor.valueNames().begin(), sensor.valueNames().end());
        return names;
      },
      py::arg("sensors"), py::arg("scene"));
  module.def("step_many", &stepMany, py::arg("simulations"), py::arg("names"), py::arg("setpoints"),
             py::arg("times"), py::arg("cells"), py::arg("threads"));
}

}  // namespace ratchet_sieve
