#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "ratchet_sieve/page/answer_page.h"
#include "ratchet_sieve/page/live_page.h"
#include "ratchet_sieve/page/run_page.h"
#include "ratchet_sieve/recording/atomic_file.h"
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

/// The frames of a run in the order of time.
/// @param frames of each time a tuple: the time, the array of the disks, the fields of the base, and of the
/// bins of each species
void handOver(const Scene& scene, const py::list& frames, FrameSink& sink)
{
  bool begun = false;
  for (const py::handle& item : frames)
  {
    const auto [time, array, base_fields, bins_fields] =
        item.cast<std::tuple<double, py::array, py::dict, std::vector<py::dict>>>();
    if (!begun)
      sink.take(sceneFrame(scene.definition, time));
    begun = true;
    BaseFrame base;
    base.time = time;
    setFields(base.base, base_fields);
    sink.take(base);
    sink.take(ParticleFrame{time, disksOf(array)});
    if (!sink.wants(FrameKind::BINS))
      continue;
    BinFrame bins;
    bins.time = time;
    bins.species = speciesNames(scene.definition);
    for (const py::dict& fields : bins_fields)
      setFields(bins.bins.emplace_back(), fields);
    sink.take(bins);
  }
}

/// @param frames see handOver()
void writeTrajectory(const std::string& path, const Scene& scene, const py::list& frames)
{
  TrajectoryFile file(path);
  handOver(scene, frames, file);
  file.commit();
}

/// @param frames see handOver() @param others further frames of the run, as run() returns them
/// @param summary see RunPage::write(), as JSON
void writePageOf(const std::string& path, const std::string& title, const Scene& scene,
                 const py::list& frames, const py::list& others, const std::string& summary, double megabytes)
{
  const double size = BYTES_PER_MB * megabytes;
  if (!(size >= SMALLEST_PAGE && size <= LARGEST_PAGE))
    throw std::invalid_argument(fmt::format("megabytes = {}: must be {} to {}", megabytes,
                                            SMALLEST_PAGE / BYTES_PER_MB, LARGEST_PAGE / BYTES_PER_MB));
  RunPage page(static_cast<std::size_t>(size));
  handOver(scene, frames, page);
  for (const py::handle& other : others)
    if (py::isinstance<StatisticsFrame>(other))
      page.take(other.cast<StatisticsFrame>());
    else
      page.take(other.cast<ObservedFrame>());
  page.write(path, title, nlohmann::ordered_json::parse(summary));
}

using OfferedParts = std::tuple<std::string, std::string, std::string, Scene>;

void writeLivePageOf(const std::string& path, const std::vector<OfferedParts>& scenes,
                     const py::bytes& engine)
{
  std::vector<OfferedScene> offered;
  offered.reserve(scenes.size());
  for (const auto& [name, title, sentence, scene] : scenes)
    offered.push_back({name, title, sentence, scene});
  writeLivePage(path, offered, engine);
}

/// A frame that Python only keeps, for the page.
template <typename Frame>
void bindKept(py::module_& module, const char* name)
{
  py::class_<Frame>(module, name)
      .def(py::pickle([](const Frame& frame) { return fieldsOf(frame); },
                      [](const py::dict& fields)
                      {
                        Frame frame;
                        setFields(frame, fields);
                        return frame;
                      }));
}

}  // namespace

void bindFrames(py::module_& module)
{
  bindKept<StatisticsFrame>(module, "_StatisticsFrame");
  bindKept<ObservedFrame>(module, "_ObservedFrame");
  module.def("write_trajectory", &writeTrajectory, py::arg("path"), py::arg("scene"), py::arg("frames"));
  module.def("write_page", &writePageOf, py::arg("path"), py::arg("title"), py::arg("scene"),
             py::arg("frames"), py::arg("others"), py::arg("summary"), py::arg("megabytes"));
  py::class_<NamedFile>(module, "NamedFile")
      .def(py::init(
          [](const std::string& name, const std::string& path) {
            return NamedFile{name, path};
          }));
  module.def("require_distinct", &requireDistinct, py::arg("inputs"), py::arg("outputs"));
  module.def("answer_page", &answerPage, py::arg("answer"));
  module.def("write_live_page", &writeLivePageOf, py::arg("path"), py::arg("scenes"), py::arg("engine"));
}

}  // namespace ratchet_sieve
