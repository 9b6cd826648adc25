#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

Scene sceneOfText(const std::string& text, const std::string& source,
                  const std::vector<std::string>& overrides)
{
  YAML::Node root = copyableYaml(text, source);
  for (const std::string& assignment : overrides)
    applyOverride(root, assignment);
  return sceneFromYaml(root, source);
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
      .def_readonly("warnings", &Scene::warnings);
  module.def("load_scene", &loadSceneFile, py::arg("path"), py::arg("overrides"));
  module.def("scene_of_text", &sceneOfText, py::arg("text"), py::arg("source"), py::arg("overrides"));
}

}  // namespace ratchet_sieve
