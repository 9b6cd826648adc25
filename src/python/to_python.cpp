#include "to_python.h"

#include <cstdint>
#include <stdexcept>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

struct DiskRow
{
  std::uint32_t id;
  std::uint32_t species;
  double radius;
  double mass;
  double x;
  double y;
  double vx;
  double vy;
  double angle;
  double spin;
  double displacement;
};

struct CollisionRow
{
  double time;
  std::int32_t kind;
  std::int64_t i;
  std::int64_t j;
  double normal_speed;
  double normal_impulse;
  double tangential_impulse;
};

struct ExitRow
{
  double time;
  std::uint32_t id;
  std::uint32_t species;
  double radius;
  double mass;
  std::int32_t side;
  double place;
};

/// As the scene's reader takes it: 020 is 20, and true and false alone are no text.
py::object scalarToPython(const YAML::Node& node)
{
  const std::string& text = node.Scalar();
  double number = 0.0;
  if (node.Tag() == "!")
    return py::str(text);
  if (YAML::convert<double>::decode(node, number))
  {
    const bool whole = text.find_first_not_of("+-0123456789") == std::string::npos;
    return whole ? py::reinterpret_steal<py::object>(PyLong_FromString(text.c_str(), nullptr, 10))
                 : py::object(py::float_(number));
  }
  if (text == "true" || text == "false")
    return py::bool_(text == "true");
  return py::str(text);
}

}  // namespace

py::object toPython(const nlohmann::ordered_json& json)
{
  return py::module_::import("json").attr("loads")(json.dump());
}

py::object toPython(const YAML::Node& node, bool is_name)
{
  if (node.IsMap())
  {
    py::dict dict;
    for (const auto& item : node)
    {
      const std::string& key = item.first.Scalar();
      dict[py::str(key)] = toPython(item.second, key == "name" || key == "species");
    }
    return dict;
  }
  if (node.IsSequence())
  {
    py::list list;
    for (const YAML::Node& item : node)
      list.append(toPython(item, is_name));
    return list;
  }
  if (!node.IsScalar())
    return py::none();
  return is_name ? py::str(node.Scalar()) : scalarToPython(node);
}

py::array arrayOf(const std::vector<DiskState>& disks, const SceneDefinition& scene)
{
  py::array_t<DiskRow> rows(static_cast<py::ssize_t>(disks.size()));
  DiskRow* row = rows.mutable_data();
  for (const DiskState& disk : disks)
  {
    const double radius = radiusOf(disk, scene.species);
    *row++ = {disk.id,    disk.species, radius,           massOf(disk, scene.species),
              disk.x,     disk.y,       disk.vx,          disk.vy,
              disk.angle, disk.spin,    disk.displacement};
  }
  return std::move(rows);
}

std::vector<DiskState> disksOf(const py::array& rows)
{
  if (!py::isinstance<py::array_t<DiskRow>>(rows) || rows.ndim() != 1)
    throw std::invalid_argument("the disks of a frame must be an array as Simulation.disks gives it");
  const py::array_t<DiskRow, py::array::c_style> own(rows);
  std::vector<DiskState> disks;
  disks.reserve(static_cast<std::size_t>(own.size()));
  for (py::ssize_t k = 0; k < own.size(); ++k)
  {
    const DiskRow& row = own.data()[k];
    disks.push_back({row.id, row.species, row.x, row.y, row.angle, row.vx, row.vy, row.spin, row.displacement,
                     row.radius});
  }
  return disks;
}

py::array arrayOf(const std::vector<CollisionRecord>& collisions)
{
  py::array_t<CollisionRow> rows(static_cast<py::ssize_t>(collisions.size()));
  CollisionRow* row = rows.mutable_data();
  for (const CollisionRecord& collision : collisions)
    *row++ = {collision.time,
              static_cast<std::int32_t>(collision.kind),
              collision.i,
              collision.j ? static_cast<std::int64_t>(*collision.j) : -1,
              collision.normal_speed,
              collision.normal_impulse,
              collision.tangential_impulse};
  return std::move(rows);
}

py::array arrayOf(const std::vector<ExitRecord>& exits)
{
  py::array_t<ExitRow> rows(static_cast<py::ssize_t>(exits.size()));
  ExitRow* row = rows.mutable_data();
  for (const ExitRecord& exit : exits)
    *row++ = {exit.time, exit.id, exit.species, exit.radius, exit.mass, static_cast<std::int32_t>(exit.side),
              exit.place};
  return std::move(rows);
}

void describeArrays()
{
  PYBIND11_NUMPY_DTYPE(ExitRow, time, id, species, radius, mass, side, place);
  PYBIND11_NUMPY_DTYPE(DiskRow, id, species, radius, mass, x, y, vx, vy, angle, spin, displacement);
  PYBIND11_NUMPY_DTYPE(CollisionRow, time, kind, i, j, normal_speed, normal_impulse, tangential_impulse);
}

}  // namespace ratchet_sieve
