#include <memory>
#include <string>
#include <tuple>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/recording/trajectory_file.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

SceneFrame sceneFrame(const SceneDefinition& scene, double time)
{
  SceneFrame frame;
  frame.time = time;
  frame.yaml = canonicalYaml(scene);
  frame.scene_hash = sceneHash(scene);
  frame.seed = scene.seed;
  frame.version = version();
  return frame;
}

/// @param frames tuples of the time, the array of the disks and the fields of the base
void writeTrajectory(const std::string& path, const Scene& scene, const py::list& frames)
{
  const std::unique_ptr<TrajectoryFile> file = openTrajectory(path);
  bool begun = false;
  for (const py::handle& item : frames)
  {
    const auto [time, array, fields] = item.cast<std::tuple<double, py::array, py::dict>>();
    if (!begun)
      file->take(sceneFrame(scene.definition, time));
    begun = true;
    BaseFrame base;
    base.time = time;
    setFields(base.base, fields);
    file->take(base);
    file->take(ParticleFrame{time, disksOf(array)});
  }
  file->commit();
}

}  // namespace

void bindTrajectory(py::module_& module)
{
  module.def("write_trajectory", &writeTrajectory, py::arg("path"), py::arg("scene"), py::arg("frames"));
}

}  // namespace ratchet_sieve
