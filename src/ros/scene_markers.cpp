#include "ratchet_sieve/ros/scene_markers.h"

#include <cmath>

#include <fmt/format.h>

#include "marker_style.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/ros/transform_publisher.h"

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
constexpr double BIN_HEIGHT = 0.20;
constexpr double BIN_GAP = 0.02;  // between the base's end and a bin
constexpr double LETTER = 0.024;
constexpr double CAPTION_HEIGHT = 0.25;  // above the middle of the base

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

std::string orUndefined(const std::optional<double>& value)
{
  return value ? fmt::format("{:.3f}", *value) : "undefined";
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
  Marker box = marker(WORLD_FRAME_ID, frame.time, place.name, 0, Marker::LINE_STRIP, grey(0.35f));
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
    Marker fill = marker(WORLD_FRAME_ID, frame.time, place.name, id, Marker::TRIANGLE_LIST, speciesColor(k));
    addRectangle(fill, place.x + column * (k + 0.15), place.y, 0.7 * column, level * height);
    markers.markers.push_back(fill);
    markers.markers.push_back(text(frame.time, std::string(place.name) + "_count", id,
                                   place.x + column * (k + 0.5), place.y - 1.3 * LETTER * scale,
                                   LETTER * scale, fmt::format("{} {}", frame.species[k], bins.*side)));
  }
}
}  // namespace

MarkerArray baseMarkers(const SceneDefinition& scene, double time)
{
  const double width = scene.base.width();
  Marker body = marker(BASE_FRAME_ID, time, "base", 0, Marker::TRIANGLE_LIST, grey(0.55f));
  Marker outline = marker(BASE_FRAME_ID, time, "base", 1, Marker::LINE_LIST, grey(0.2f));
  outline.scale.x = LINE_WIDTH * width;
  for (int tooth = 0; tooth < scene.base.teeth; ++tooth)
    addTooth(scene.base, tooth, body, outline);
  addRectangle(body, 0.0, -BEAM_HEIGHT * width, width, BEAM_HEIGHT * width);
  MarkerArray markers;
  markers.markers = {body, outline};
  return markers;
}

MarkerArray diskMarkers(const SceneDefinition& scene, const ParticleFrame& frame)
{
  MarkerArray markers;
  for (std::size_t k = 0; k < scene.species.size(); ++k)
  {
    Marker disks = marker(WORLD_FRAME_ID, frame.time, "disks", static_cast<int>(k), Marker::SPHERE_LIST,
                          speciesColor(k));
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

MarkerArray binMarkers(const SceneDefinition& scene, const BinFrame& frame, const DriveState& base)
{
  MarkerArray markers;
  if (scene.boundary != Boundary::OPEN)
    return markers;
  const double width = scene.base.width();
  const double drop = (BIN_HEIGHT + 2.0 * BEAM_HEIGHT) * width;
  const BinPlace left{"left_bin", -(BIN_WIDTH + BIN_GAP) * width, -drop};
  const BinPlace right{"right_bin", width * (std::cos(base.inclination) + BIN_GAP),
                       width * std::sin(base.inclination) - drop};
  addBin(scene, frame, left, &SpeciesBins::left, markers);
  addBin(scene, frame, right, &SpeciesBins::right, markers);
  return markers;
}

MarkerArray captionMarkers(const SceneDefinition& scene, const BinFrame& frame, const DriveState& base)
{
  const double width = scene.base.width();
  std::string words = fmt::format("t = {:.2f} s    theta = {:+.3f} rad    f = {:.1f} Hz    A = {:.2f} mm",
                                  frame.time, base.inclination, base.frequency, 1e3 * base.amplitude);
  if (scene.boundary == Boundary::OPEN)
    words += fmt::format("\nQ = {}    P = {}", orUndefined(frame.quality), orUndefined(frame.processed));
  const double x = 0.5 * width * std::cos(base.inclination);
  const double y = 0.5 * width * std::sin(base.inclination) + CAPTION_HEIGHT * width;
  MarkerArray markers;
  markers.markers.push_back(text(frame.time, "caption", 0, x, y, LETTER * width, words));
  return markers;
}

}  // namespace ratchet_sieve
