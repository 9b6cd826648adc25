#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "commanded_quantities.h"
#include "many_simulations.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

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

/// What is read of each simulation at the end of a step, one row for each: columns of numpy arrays.
class Readings
{
public:
  Readings(std::size_t rows, std::size_t species, std::size_t cells)
      : species_(species),
        cells_(cells),
        time_(rows),
        bins_({rows, species, fieldNames<SpeciesBins>().size()}),
        base_({rows, fieldNames<DriveState>().size()}),
        mean_vx_({rows, species}),
        mean_vx_defined_({rows, species}),
        histogram_({rows, species, cells}),
        to_time_(time_.mutable_data()),
        to_bins_(bins_.mutable_data()),
        to_base_(base_.mutable_data()),
        to_mean_vx_(mean_vx_.mutable_data()),
        to_mean_vx_defined_(mean_vx_defined_.mutable_data()),
        to_histogram_(histogram_.mutable_data())
  {
  }

  /// Writes a row. Python's lock is not needed. @param before the disks at the start of the step, which was
  /// `elapsed` ago [s]
  void read(std::size_t row, RunningSimulation::Use& simulation, const std::vector<DiskState>& before,
            double elapsed)
  {
    const DriveState base = simulation->base();
    to_time_[row] = simulation->time();
    double* to = to_bins_ + row * species_ * (bins_.size() / (time_.size() * species_));
    for (const SpeciesBins& bins : simulation->bins())
      to = writeFields(bins, to);
    writeFields(base, to_base_ + row * (base_.size() / time_.size()));
    const std::vector<DiskState> disks = simulation->disks();
    readVelocities(row, before, disks, elapsed);
    readHistogram(row, disks, base, simulation->scene().base.width());
  }

  py::dict columns() const
  {
    py::dict columns;
    columns["time"] = time_;
    columns["bins"] = bins_;
    columns["base"] = base_;
    columns["mean_vx"] = mean_vx_;
    columns["mean_vx_defined"] = mean_vx_defined_;
    columns["histogram"] = histogram_;
    return columns;
  }

private:
  /// Of the disks that were in the machine during all of the step. Both lists are in the order of ids.
  void readVelocities(std::size_t row, const std::vector<DiskState>& before,
                      const std::vector<DiskState>& after, double elapsed)
  {
    std::vector<double> paths(species_);
    std::vector<std::size_t> counts(species_);
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
    for (std::size_t k = 0; k < species_; ++k)
    {
      const bool defined = counts[k] > 0 && elapsed > 0.0;
      to_mean_vx_[row * species_ + k] = defined ? paths[k] / (static_cast<double>(counts[k]) * elapsed) : 0.0;
      to_mean_vx_defined_[row * species_ + k] = defined;
    }
  }

  /// Along the base; what is beyond an end counts in the cell at that end.
  void readHistogram(std::size_t row, const std::vector<DiskState>& disks, const DriveState& base,
                     double width)
  {
    double* const counts = to_histogram_ + row * species_ * cells_;
    std::fill_n(counts, species_ * cells_, 0.0);
    if (cells_ == 0)
      return;
    const double cosine = std::cos(base.inclination);
    const double sine = std::sin(base.inclination);
    const auto last = static_cast<double>(cells_ - 1);
    for (const DiskState& disk : disks)
    {
      const double s = (disk.x - base.horizontal_displacement) * cosine + (disk.y - base.displacement) * sine;
      const double cell = std::clamp(std::floor(s / width * static_cast<double>(cells_)), 0.0, last);
      counts[disk.species * cells_ + static_cast<std::size_t>(cell)] += 1.0;
    }
  }

  std::size_t species_;
  std::size_t cells_;
  py::array_t<double> time_;
  py::array_t<double> bins_;
  py::array_t<double> base_;
  py::array_t<double> mean_vx_;
  py::array_t<bool> mean_vx_defined_;
  py::array_t<double> histogram_;
  double* to_time_;
  double* to_bins_;
  double* to_base_;
  double* to_mean_vx_;
  bool* to_mean_vx_defined_;
  double* to_histogram_;
};

/// Commands each simulation its setpoints, advances it to its time, and reads it, on several threads.
/// @param names of the commanded quantities @param setpoints a row for each simulation, a column for each
/// name @param cells of the histograms along the base
/// @return columns of Readings; of each simulation the text of the collapse that ended it, or None
py::tuple stepMany(const std::vector<std::shared_ptr<RunningSimulation>>& simulations,
                   const std::vector<std::string>& names, const Doubles& setpoints,
                   const std::vector<double>& times, std::size_t cells, std::size_t threads)
{
  const std::size_t count = simulations.size();
  if (count == 0 || times.size() != count ||
      static_cast<std::size_t>(setpoints.size()) != count * names.size())
    throw std::invalid_argument("there must be one time and one row of setpoints for each simulation");
  const std::size_t species = simulations.front()->scene()->definition.species.size();
  for (const std::shared_ptr<RunningSimulation>& simulation : simulations)
    if (simulation->scene()->definition.species.size() != species)
      throw std::invalid_argument("the simulations must have the same number of species");
  std::vector<Setpoints> commands(count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t q = 0; q < names.size(); ++q)
      commands[k][names[q]] = setpoints.data()[k * names.size() + q];
  for (const Setpoints& command : commands)
    requireLegal(command);
  Readings readings(count, species, cells);
  std::vector<std::string> collapses(count);
  withMany(simulations, threads,
           [&](std::size_t k, const std::function<bool()>& stop_wanted)
           {
             std::vector<DiskState> before;
             double start = 0.0;
             {
               RunningSimulation::Use simulation(*simulations[k]);
               commandAll(commands[k], *simulation);
               before = simulation->disks();
               start = simulation->time();
             }
             try
             {
               simulations[k]->advanceTo(times[k], stop_wanted);
             }
             catch (const StallError& error)
             {
               collapses[k] = error.what();
             }
             RunningSimulation::Use simulation(*simulations[k]);
             readings.read(k, simulation, before, simulation->time() - start);
           });
  py::list texts;
  for (const std::string& text : collapses)
    texts.append(text.empty() ? py::object(py::none()) : py::str(text));
  return py::make_tuple(readings.columns(), texts);
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
  module.attr("BASE_FIELDS") = py::tuple(py::cast(fieldNames<DriveState>()));
  module.def("step_many", &stepMany, py::arg("simulations"), py::arg("names"), py::arg("setpoints"),
             py::arg("times"), py::arg("cells"), py::arg("threads"));
}

}  // namespace ratchet_sieve
