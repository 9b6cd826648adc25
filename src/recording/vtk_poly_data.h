#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ratchet_sieve
{

/// Numbers of each point.
struct VtkArray
{
  std::string name;
  std::size_t components = 1;
  std::variant<std::vector<double>, std::vector<std::int64_t>> values;
};

/// The contents of a VTK PolyData file.
struct VtkPolyData
{
  /// How the points are shown.
  enum class Cells
  {
    VERTICES,  ///< each by itself
    LINE       ///< as one line
  };

  double time = 0.0;
  Cells cells = Cells::VERTICES;
  std::vector<double> points;  ///< x, y, z of each
  std::vector<VtkArray> arrays;
  std::vector<std::string> species;  ///< names
};

/// The text of the file (.vtp): XML with its arrays inline, in base64, so that numbers are read back bit for
/// bit. Format: VTK file formats, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
std::string vtkText(const VtkPolyData& data);

}  // namespace ratchet_sieve
