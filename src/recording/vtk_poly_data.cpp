#include "vtk_poly_data.h"

#include <cstring>
#include <numeric>
#include <type_traits>

#include <fmt/format.h>

#include "ratchet_sieve/recording/base64.h"

namespace ratchet_sieve
{
namespace
{

/// The number's bytes, the lowest first.
template <typename Number>
void appendBytes(Number number, std::string& bytes)
{
  static_assert(sizeof(Number) == sizeof(std::uint64_t));
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  for (int shift = 0; shift < 64; shift += 8)
    bytes += static_cast<char>((bits >> shift) & 0xff);
}

/// An array's contents: its size in bytes (header_type), then its numbers.
template <typename Number>
std::string encoded(const std::vector<Number>& numbers)
{
  std::string bytes;
  appendBytes(static_cast<std::uint64_t>(numbers.size() * sizeof(Number)), bytes);
  for (const Number number : numbers)
    appendBytes(number, bytes);
  return base64(bytes);
}

template <typename Number>
std::string arrayText(const char* name, const std::string& shape, const std::vector<Number>& numbers)
{
  const char* type = std::is_same_v<Number, double> ? "Float64" : "Int64";
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" {} format=\"binary\">{}</DataArray>\n", type, name,
                     shape, encoded(numbers));
}

std::string componentsText(std::size_t components)
{
  return fmt::format("NumberOfComponents=\"{}\"", components);
}

/// Text as the codes of its bytes, each name ended by a 0.
std::string namesText(const std::vector<std::string>& names)
{
  std::string codes;
  for (const std::string& name : names)
  {
    for (const unsigned char c : name)
      codes += fmt::format("{} ", c);
    codes += "0 ";
  }
  return fmt::format(
      "<Array type=\"String\" Name=\"species_names\" NumberOfTuples=\"{}\" format=\"ascii\">{}</Array>\n",
      names.size(), codes);
}

/// Cells of points in their order. @param ends for each cell, one past the index of its last point
std::string cellsText(std::size_t points, const std::vector<std::int64_t>& ends)
{
  std::vector<std::int64_t> order(points);
  std::iota(order.begin(), order.end(), 0);
  return arrayText("connectivity", "", order) + arrayText("offsets", "", ends);
}

}  // namespace

std::string vtkText(const VtkPolyData& data)
{
  const std::size_t points = data.points.size() / 3;
  const bool line = data.cells == VtkPolyData::Cells::LINE;
  std::vector<std::int64_t> ends(line ? 1 : points, static_cast<std::int64_t>(points));
  if (!line)
    std::iota(ends.begin(), ends.end(), 1);

  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<FieldData>\n";
  text += arrayText("TimeValue", "NumberOfTuples=\"1\"", std::vector<double>{data.time});
  if (!data.species.empty())
    text += namesText(data.species);
  text += fmt::format(
      "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n",
      points, line ? 0 : points, line ? 1 : 0);
  for (const VtkArray& array : data.arrays)
    text += std::visit([&](const auto& values)
                       { return arrayText(array.name.c_str(), componentsText(array.components), values); },
                       array.values);
  text += "</PointData>\n<Points>\n" + arrayText("Points", componentsText(3), data.points) + "</Points>\n";
  const char* cells = line ? "Lines" : "Verts";
  text += fmt::format("<{0}>\n{1}</{0}>\n", cells, cellsText(points, ends));
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace ratchet_sieve
