#include "vtk_trajectory.h"

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base_outline.h"
#include "trajectory_paths.h"
#include "vtk_poly_data.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* FRAME_ENDING = ".vtp";

constexpr const char* COLLECTION_HEAD =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
    "<Collection>\n";
constexpr const char* COLLECTION_END = "</Collection>\n</VTKFile>\n";

/// As the value of an attribute.
std::string xmlText(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  return escaped;
}

VtkPolyData vtkDisks(const SceneDefinition& scene, const ParticleFrame& particles)
{
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> species;
  std::vector<double> positions;
  std::vector<double> velocities;
  std::vector<double> radii;
  std::vector<double> masses;
  std::vector<double> angles;
  std::vector<double> spins;
  std::vector<double> displacements;
  for (const DiskState& disk : particles.disks)
  {
    ids.push_back(disk.id);
    species.push_back(disk.species);
    positions.insert(positions.end(), {disk.x, disk.y, 0.0});
    velocities.insert(velocities.end(), {disk.vx, disk.vy, 0.0});
    radii.push_back(radiusOf(disk, scene.species));
    masses.push_back(scene.species[disk.species].massOf(radii.back()));
    angles.push_back(disk.angle);
    spins.push_back(disk.spin);
    displacements.push_back(disk.displacement);
  }
  VtkPolyData data;
  data.time = particles.time;
  data.points = std::move(positions);
  data.arrays = {{"id", 1, std::move(ids)},
                 {"species", 1, std::move(species)},
                 {"radius", 1, std::move(radii)},
                 {"mass", 1, std::move(masses)},
                 {"velocity", 3, std::move(velocities)},
                 {"spin", 1, std::move(spins)},
                 {"angle", 1, std::move(angles)},
                 {"displacement", 1, std::move(displacements)}};
  data.species = speciesNames(scene);
  return data;
}

VtkPolyData vtkBase(const SceneDefinition& scene, const DriveState& base, double time)
{
  VtkPolyData data;
  data.time = time;
  data.cells = VtkPolyData::Cells::LINE;
  for (const Eigen::Vector2d& corner : baseOutline(scene, base))
    data.points.insert(data.points.end(), {corner.x(), corner.y(), 0.0});
  return data;
}

}  // namespace

VtkTrajectory::VtkTrajectory(const std::string& path)
    : disks_(path),
      base_(basePath(path)),
      frames_(framesPath(path), FRAME_ENDING),
      folder_(xmlText(std::filesystem::path(framesPath(path)).filename().string()))
{
  for (AtomicFile* collection : {&disks_, &base_})
    collection->stream() << COLLECTION_HEAD;
}

void VtkTrajectory::write(const Instant& instant)
{
  const auto& [scene, base, particles] = instant;
  const auto add =
      [&, time = particles.time](const char* series, const VtkPolyData& data, AtomicFile& collection)
  {
    const std::string name = fmt::format("{}_{:06}", series, next_);
    frames_.write(name, vtkText(data));
    collection.stream() << fmt::format("<DataSet timestep=\"{}\" file=\"{}/{}{}\"/>\n", time, folder_, name,
                                       FRAME_ENDING);
  };
  add("disks", vtkDisks(scene, particles), disks_);
  add("base", vtkBase(scene, base, particles.time), base_);
  ++next_;
}

void VtkTrajectory::commit()
{
  for (AtomicFile* collection : {&disks_, &base_})
  {
    collection->stream() << COLLECTION_END;
    collection->finish();
  }
  frames_.commit();
  disks_.commit();
  base_.commit();
}

}  // namespace ratchet_sieve
