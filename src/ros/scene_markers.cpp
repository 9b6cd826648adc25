#include "ratchet_sieve/ros/scene_markers.h"

#include <cmath>

#include <fmt/format.h>

#include "marker_style.h"
#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Proportions of what is only drawn, in widths of the base.
constexpr double BEAM_HEIGHT = 0.02;
constexpr double LINE_WIDTH = 0.001;
constexpr double BIN_WIDTH = 0.14;
constexpr double BIN_HEIGHT = 0.17;
constexpr double BIN_GAP = 0.02;  // between the base's end and a bin
constexpr double LETTER = 0.024;
constexpr double CAPTION_HEIGHT = 0.23;  // above the middle of the base
constexpr double LEGEND_DEPTH = 0.12;    // of its first line, below the middle of the base
constexpr double LINE_HEIGHT = 1.5;      // in letters
constexpr double MM_PER_M = 1e3;
constexpr double G_PER_KG = 1e3;

void addTooth(const BaseDefinition& base, int tooth, Marker& triangles, Marker& outline)
{
  const double start = tooth * base.tooth_width;
  const auto left = planePoint(start, 0.0);
  const auto apex = planePoint(start + base.asymmetry * base.tooth_width, base.tooth_height);
  const auto right = planePoint(start + base.tooth_width, 0.0);
  for (const auto& point : {left, right, apex})
    triangles.points.push_back(point);
  for (const auto& point : {left, apex, apex, right})
    outline.points.push_back(point);
}

/// "theta = +0.100 rad"; on its way to a setpoint "theta = +0.100 -> +0.190 rad".
template <typename Format>
std::string quantityText(const char* name, const Format& format, double applied, double commanded,
                         const char* unit)
{
  const std::string now = fmt::format(format, applied);
  const std::string then = fmt::format(format, commanded);
  return fmt::format("{} = {}{}{} {}", name, now, now == then ? "" : " -> ", now == then ? "" : then, unit);
}

std::string orUndefined(const std::optional<double>& value)
{
  return value ? fmt::format("{:.3f}", *value) : "undefined";
}

std::string captionText(const Picture& picture)
{
  const DriveState& base = picture.base.base;
  std::string words = fmt::format(
      "t = {:.2f} s    {}    {}    {}", picture.base.time,
      quantityText("theta", FMT_STRING("{:+.3f}"), base.inclination, base.commanded_inclination, "rad"),
      quantityText("f", FMT_STRING("{:.1f}"), base.frequency, base.commanded_frequency, "Hz"),
      quantityText("A", FMT_STRING("{:.2f}"), MM_PER_M * base.amplitude, MM_PER_M * base.commanded_amplitude,
                   "mm"));
  if (picture.scene.boundary == Boundary::OPEN && picture.bins)
    words += fmt::format("\nQ = {}    P = {}", orUndefined(picture.bins->quality),
                         orUndefined(picture.bins->processed));
  return words;
}

std::string legendText(const Picture& picture, std::size_t species)
{
  const SpeciesDefinition& kind = picture.scene.species[species];
  const std::string words =
      fmt::format("{}: r = {:g} mm, m = {:g} g", kind.name, MM_PER_M * kind.radius, G_PER_KG * kind.mass);
  return picture.bins ? fmt::format("{}, {} on the base", words, picture.bins->bins[species].on_base) : words;
}

/// One of the two bins: its lower left corner, in a world that stands still.
struct BinPlace
{
  const char* name;
  double x;
  double y;
};

void addBin(const SceneDefinition& scene, const BinFrame& frame, const BinPlace& place,
            std::uint64_t SpeciesBins::*side, MarkerArray& markers)
{
  const double scale = scene.base.width();
  const double width = BIN_WIDTH * scale;
  const double height = BIN_HEIGHT * scale;
  Marker box = marker(frame.time, place.name, 0, Marker::LINE_STRIP, grey(0.35f));
  box.scale.x = 2.0 * LINE_WIDTH * scale;
  box.points = {planePoint(place.x, place.y + height), planePoint(place.x, place.y),
                planePoint(place.x + width, place.y), planePoint(place.x + width, place.y + height)};
  markers.markers.push_back(box);
  const double column = width / static_cast<double>(frame.bins.size());
  for (std::size_t k = 0; k < frame.bins.size(); ++k)
  {
    const SpeciesBins& bins = frame.bins[k];
    const double all = static_cast<double>(bins.counted() + bins.on_base);
    const double level = all > 0.0 ? static_cast<double>(bins.*side) / all : 0.0;
    const int id = static_cast<int>(k) + 1;
    Marker fill = marker(frame.time, place.name, id, Marker::TRIANGLE_LIST, speciesColor(k));
    addRectangle(fill, place.x + column * (k + 0.15), place.y, 0.7 * column, level * height);
    markers.markers.push_back(fill);
    markers.markers.push_back(text(frame.time, std::string(place.name) + "_count", id,
                                   place.x + column * (k + 0.5), place.y - 1.8 * LETTER * scale,
                                   LETTER * scale, fmt::format("{}\n{}", frame.species[k], bins.*side)));
  }
}
}  // namespace

MarkerArray baseMarkers(const SceneDefinition& scene, const BaseFrame& base)
{
  const double width = scene.base.width();
  Marker body = marker(base.time, "base", 0, Marker::TRIANGLE_LIST, grey(0.55f));
  Marker outline = marker(base.time, "base", 1, Marker::LINE_LIST, grey(0.2f));
  outline.scale.x = LINE_WIDTH * width;
  for (int tooth = 0; tooth < scene.base.teeth; ++tooth)
    addTooth(scene.base, tooth, body, outline);
  addRectangle(body, 0.0, -BEAM_HEIGHT * width, width, BEAM_HEIGHT * width);
  MarkerArray markers;
  markers.markers = {body, outline};
  for (Marker& part : markers.markers)
  {
    part.pose.position.z = base.base.displacement;
    // y of the world points away from the viewer: a turn that raises the right end is negative about it.
    part.pose.orientation.w = std::cos(0.5 * base.base.inclination);
    part.pose.orientation.y = -std::sin(0.5 * base.base.inclination);
  }
  return markers;
}

MarkerArray diskMarkers(const SceneDefinition& scene, const ParticleFrame& frame)
{
  MarkerArray markers;
  for (std::size_t k = 0; k < scene.species.size(); ++k)
  {
    Marker disks = marker(frame.time, "disks", static_cast<int>(k), Marker::SPHERE_LIST, speciesColor(k));
    disks.scale.x = disks.scale.y = disks.scale.z = 2.0 * scene.species[k].radius;
    markers.markers.push_back(disks);
  }
  for (const DiskState& disk : frame.disks)
    markers.markers[disk.species].points.push_back(planePoint(disk.x, disk.y));
  // RViz calls an empty list an error.
  for (Marker& disks : markers.markers)
    if (disks.points.empty())
      disks.action = Marker::DELETE;
  return markers;
}

MarkerArray binMarkers(const SceneDefinition& scene, const BinFrame& frame, const BaseFrame& base)
{
  MarkerArray markers;
  if (scene.boundary != Boundary::OPEN)
    return markers;
  const double width = scene.base.width();
  const double inclination = base.base.inclination;
  const double drop = (BIN_HEIGHT + 2.0 * BEAM_HEIGHT) * width;
  const BinPlace left{"left_bin", -(BIN_WIDTH + BIN_GAP) * width, -drop};
  const BinPlace right{"right_bin", width * (std::cos(inclination) + BIN_GAP),
                       width * std::sin(inclination) - drop};
  addBin(scene, frame, left, &SpeciesBins::left, markers);
  addBin(scene, frame, right, &SpeciesBins::right, markers);
  return markers;
}

MarkerArray captionMarkers(const Picture& picture)
{
  const BaseDefinition& base = picture.scene.base;
  const double inclination = picture.base.base.inclination;
  const double letter = LETTER * base.width();
  const double x = 0.5 * base.width() * std::cos(inclination);
  const double y = 0.5 * base.width() * std::sin(inclination);
  MarkerArray markers;
  markers.markers.push_back(text(picture.base.time, "caption", 0, x, y + CAPTION_HEIGHT * base.width(),
                                 letter, captionText(picture)));
  for (std::size_t k = 0; k < picture.scene.species.size(); ++k)
  {
    const double depth = LEGEND_DEPTH * base.width() + static_cast<double>(k) * LINE_HEIGHT * letter;
    markers.markers.push_back(text(picture.base.time, "legend", static_cast<int>(k), x, y - depth, letter,
                                   legendText(picture, k), speciesColor(k)));
  }
  return markers;
}

MarkerArray pictureMarkers(const Picture& picture)
{
  MarkerArray all = baseMarkers(picture.scene, picture.base);
  const auto append = [&all](const MarkerArray& part)
  { all.markers.insert(all.markers.end(), part.markers.begin(), part.markers.end()); };
  if (picture.particles)
    append(diskMarkers(picture.scene, *picture.particles));
  if (picture.bins)
    append(binMarkers(picture.scene, *picture.bins, picture.base));
  append(captionMarkers(picture));
  return all;
}

}  // namespace ratchet_sieve
