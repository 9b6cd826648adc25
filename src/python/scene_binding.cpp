#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/sizes.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

/// The bytes of a YAML file. The thread that writes a pipe may be one of Python's.
py::bytes readText(const std::string& path)
{
  std::string text;
  {
    const py::gil_scoped_release let_go;
    text = readYamlText(path);
  }
  return text;
}

/// What is given of a scene, without defaults.
py::object givenValues(const std::string& text, const std::string& source,
                       const std::vector<std::string>& overrides)
{
  YAML::Node root = copyableYaml(text, source);
  for (const std::string& assignment : overrides)
    applyOverride(root, assignment);
  return toPython(root);
}

/// Disks of a frame that was recorded.
/// @param columns of equal lengths, named as in ParticleStates.msg; an empty radius: that of the species
/// @throws std::invalid_argument the scene has no such disks
py::array recordedDisks(const Scene& scene, const std::map<std::string, py::array_t<double>>& columns)
{
  const auto size = columns.at("id").size();
  for (const auto& [name, column] : columns)
    if (column.size() != size && (name != "radius" || column.size() != 0))
      throw std::invalid_argument("there are " + std::to_string(size) + " id and " +
                                  std::to_string(column.size()) + " " + name);
  std::vector<DiskState> disks(static_cast<std::size_t>(size));
  for (py::ssize_t k = 0; k < size; ++k)
  {
    DiskState& disk = disks[static_cast<std::size_t>(k)];
    const auto set = [&columns, k](const FieldInfo& field, auto& value)
    {
      if (const auto& column = columns.at(field.name); column.size() != 0)
        value = static_cast<std::decay_t<decltype(value)>>(column.at(k));
    };
    Fields<DiskState>::each(set, disk);
    if (disk.species >= scene.definition.species.size())
      throw std::invalid_argument("the scene has no species " + std::to_string(disk.species));
  }
  return arrayOf(disks, scene.definition);
}

}  // namespace

void bindScene(py::module_& module)
{
  py::class_<Scene, std::shared_ptr<Scene>>(module, "Scene")
      .def_property_readonly("yaml", [](const Scene& scene) { return canonicalYaml(scene.definition); })
      .def_property_readonly(
          "values", [](const Scene& scene) { return toPython(YAML::Load(canonicalYaml(scene.definition))); })
      .def_property_readonly("hash", [](const Scene& scene) { return sceneHash(scene.definition); })
      .def_property_readonly("run_hash", [](const Scene& scene) { return runHash(scene.definition); })
      .def_property_readonly("species", [](const Scene& scene) { return speciesNames(scene.definition); })
      .def_property_readonly("lift", [](const Scene& scene)
                             { return peakLift(scene.definition.base) / scene.definition.gravity; })
      .def_property_readonly("mean_masses",
                             [](const Scene& scene)
                             {
                               std::vector<double> masses;
                               for (const SpeciesDefinition& species : scene.definition.species)
                                 masses.push_back(meanMass(species));
                               return masses;
                             })
      .def_readonly("warnings", &Scene::warnings)
      .def("disks_of", &recordedDisks, py::arg("columns"));
  module.def("read_text", &readText, py::arg("path"));
  module.def("scene_of_text", &sceneFromText, py::arg("text"), py::arg("source"), py::arg("overrides"));
  module.def("given_values", &givenValues, py::arg("text"), py::arg("source"), py::arg("overrides"));
}

}  // namespace ratchet_sieve
