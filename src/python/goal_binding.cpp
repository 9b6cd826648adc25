#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/seeking/goal.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// @throws std::invalid_argument text that is no goal, or names another species
Goal goalOf(const std::string& text, const std::vector<std::string>& species)
{
  const std::optional<Goal> goal = goalFromText(text);
  if (!goal)
    throw std::invalid_argument(fmt::format("{}: must be {}", text, GOAL_FORMS));
  bool known = goal->species.empty();
  for (const std::string& name : species)
    known = known || name == goal->species;
  if (!known)
    throw std::invalid_argument(fmt::format("{}: there is no species {}; there are {}", text, goal->species,
                                            fmt::join(species, ", ")));
  return *goal;
}

/// Of rows of bins (rows, species, fields of SpeciesBins), the values (0 where undefined), and whether they
/// are defined.
template <typename Measure>
py::tuple ofRows(const Doubles& rows, const Measure& measure)
{
  const auto table = rows.unchecked<3>();
  py::array_t<double> values(table.shape(0));
  py::array_t<bool> defined(table.shape(0));
  std::vector<SpeciesBins> bins(static_cast<std::size_t>(table.shape(1)));
  for (py::ssize_t row = 0; row < table.shape(0); ++row)
  {
    for (std::size_t k = 0; k < bins.size(); ++k)
    {
      py::ssize_t field = 0;
      Fields<SpeciesBins>::each(
          [&](const FieldInfo&, auto& value)
          {
            value =
                static_cast<std::decay_t<decltype(value)>>(table(row, static_cast<py::ssize_t>(k), field));
            ++field;
          },
          bins[k]);
    }
    const std::optional<double> value = measure(static_cast<std::size_t>(row), bins);
    values.mutable_at(row) = value.value_or(0.0);
    defined.mutable_at(row) = value.has_value();
  }
  return py::make_tuple(values, defined);
}

/// A goal, measured by what left in windows of time. @param durations of the windows [s]
py::tuple measuredGoals(const std::string& text, const std::vector<std::string>& species, const Doubles& rows,
                        const std::vector<double>& durations)
{
  const Goal goal = goalOf(text, species);
  return ofRows(rows,
                [&](std::size_t row, const std::vector<SpeciesBins>& bins) -> std::optional<double>
                {
                  const Measured result = measured(goal, {species, bins, durations.at(row)});
                  return result.defined ? std::optional(result.value) : std::nullopt;
                });
}

py::tuple processedRatios(const Doubles& rows)
{
  return ofRows(rows, [](std::size_t, const std::vector<SpeciesBins>& bins) { return processedRatio(bins); });
}

}  // namespace

void bindGoals(py::module_& module)
{
  module.def("measured_goals", &measuredGoals, py::arg("goal"), py::arg("species"), py::arg("bins"),
             py::arg("durations"));
  module.def("processed_ratios", &processedRatios, py::arg("bins"));
}

}  // namespace ratchet_sieve
