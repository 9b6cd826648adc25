#include "scene_markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <tf2_eigen/tf2_eigen.h>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/sizes.h"
#include "transform_publisher.h"

namespace ratchet_sieve
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

using Rgb = std::array<float, 3>;
constexpr std::array<Rgb, 8> PALETTE = {Rgb{0.000f, 0.447f, 0.698f}, Rgb{0.835f, 0.369f, 0.000f},
                                        Rgb{0.000f, 0.620f, 0.451f}, Rgb{0.800f, 0.475f, 0.655f},
                                        Rgb{0.902f, 0.624f, 0.000f}, Rgb{0.337f, 0.706f, 0.914f},
                                        Rgb{0.941f, 0.894f, 0.259f}, Rgb{0.200f, 0.200f, 0.200f}};

std_msgs::ColorRGBA opaque(const Rgb& rgb)
{
  std_msgs::ColorRGBA color;
  color.r = rgb[0];
  color.g = rgb[1];
  color.b = rgb[2];
  color.a = 1.0f;
  return color;
}

constexpr double LINE_HEIGHT = 1.5;  // in letters

/// Proportions of the decoration, in widths of the base.
constexpr double BEAM_HEIGHT = 0.02;
constexpr double WALL_THICKNESS = 0.01;
constexpr double WALL_SHOWN = 0.22;  // at most: a higher wall is cut off, because the view fits the base
constexpr double LINE_WIDTH = 0.001;
constexpr double OUTLINE_WIDTH = 0.03;  // of the teeth, at most, in widths of a tooth
constexpr double BIN_WIDTH = 0.14;
constexpr double BIN_HEIGHT = 0.17;
constexpr double BIN_GAP = 0.02;  // between the base's end and a bin

/// A dot off the centre of each disk shows its rotation. In radii of the disk.
constexpr double DOT_RADIUS = 0.28;
constexpr double DOT_OFFSET = 0.55;

/// A point of the plane. @param x to the right [m] @param y up [m]
geometry_msgs::Point planePoint(double x, double y)
{
  geometry_msgs::Point point;
  point.x = x;
  point.z = y;
  return point;
}

/// A marker in frame world, of one colour and unit pose. @param time of its stamp [s]
Marker marker(double time, const std::string& name, int id, int type, const std_msgs::ColorRGBA& color)
{
  Marker marker;
  marker.header.stamp = ros::Time(time);
  marker.header.frame_id = WORLD_FRAME_ID;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color = color;
  return marker;
}

/// Adds a rectangle to a TRIANGLE_LIST. @param x, y of its lower left corner [m]
void addRectangle(Marker& triangles, double x, double y, double width, double height)
{
  const auto lower_left = planePoint(x, y);
  const auto lower_right = planePoint(x + width, y);
  const auto upper_left = planePoint(x, y + height);
  const auto upper_right = planePoint(x + width, y + height);
  for (const auto& corner : {lower_left, lower_right, upper_right, lower_left, upper_right, upper_left})
    triangles.points.push_back(corner);
}

/// The lists of spheres in which the disks are drawn: RViz draws all spheres of a list at one size. One for
/// each species, and more for a species that has sizes, so that each disk is drawn within 2 % of its size.
struct DrawnSizes
{
  struct List
  {
    std::size_t species;
    double radius;  ///< drawn [m]
  };

  explicit DrawnSizes(const SceneDefinition& scene)
  {
    for (std::size_t k = 0; k < scene.species.size(); ++k)
    {
      const Sizes sizes(scene.species[k]);
      const int steps = static_cast<int>(std::ceil(std::log(sizes.largest() / sizes.smallest()) / STEP));
      first.push_back(lists.size());
      for (int step = 0; step <= steps; ++step)
        lists.push_back({k, sizes.smallest() * std::exp(step * STEP)});
    }
    first.push_back(lists.size());
  }

  std::size_t listOf(std::size_t species, double radius) const
  {
    const double step = std::round(std::log(radius / lists[first[species]].radius) / STEP);
    const auto last = static_cast<double>(first[species + 1] - first[species] - 1);
    return first[species] + static_cast<std::size_t>(std::clamp(step, 0.0, last));
  }

  static constexpr double STEP = 0.04;  ///< of the logarithm of the radius

  std::vector<List> lists;
  std::vector<std::size_t> first;  ///< list of each species, and the number of lists
};

/// The position of the dot on a disk, which is drawn as a sphere: on the viewer's side, where y is negative.
geometry_msgs::Point dotPoint(const DiskState& disk, double radius)
{
  const double offset = DOT_OFFSET * radius;
  geometry_msgs::Point point =
      planePoint(disk.x + offset * std::cos(disk.angle), disk.y + offset * std::sin(disk.angle));
  point.y = -std::sqrt(radius * radius - offset * offset);
  return point;
}

/// One tooth, filled down to the lowest corner of the base.
void addTooth(const std::vector<OutlineCorner>& corners, double start, double bottom, Marker& triangles,
              Marker& outline)
{
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
  {
    const auto left = planePoint(start + corners[i].s, corners[i].n);
    const auto right = planePoint(start + corners[i + 1].s, corners[i + 1].n);
    const auto under_left = planePoint(left.x, bottom);
    const auto under_right = planePoint(right.x, bottom);
    outline.points.insert(outline.points.end(), {left, right});
    if (left.z > bottom)
      triangles.points.insert(triangles.points.end(), {under_left, right, left});
    if (right.z > bottom)
      triangles.points.insert(triangles.points.end(), {under_left, under_right, right});
  }
}

void addWalls(const SceneDefinition& scene, Marker& triangles)
{
  const double width = scene.base.width();
  const double height = std::min(wallHeight(scene), WALL_SHOWN * width);
  const double below = scene.base.depth() + BEAM_HEIGHT * width;
  for (const double start : {-WALL_THICKNESS * width, width})
    addRectangle(triangles, start, -below, WALL_THICKNESS * width, below + height);
}

/// One of the two bins, by its lower left corner in the world frame.
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
  const double letter = LETTER * scale;
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
    addLines(frame.time,
             {std::string(place.name) + "_count", 2 * id, place.x + column * (k + 0.5), place.y - letter},
             letter, {{frame.species[k]}, {std::to_string(bins.*side)}}, markers);
  }
}
}  // namespace

std_msgs::ColorRGBA speciesColor(std::size_t species)
{
  return opaque(PALETTE[species % PALETTE.size()]);
}

std_msgs::ColorRGBA grey(float brightness)
{
  return opaque({brightness, brightness, brightness});
}

void addLines(double time, const TextPlace& place, double letter, const std::vector<Line>& lines,
              visualization_msgs::MarkerArray& markers)
{
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const int id = place.first_id + static_cast<int>(k);
    auto line = marker(time, place.name, id, visualization_msgs::Marker::TEXT_VIEW_FACING, lines[k].color);
    line.pose.position = planePoint(place.x, place.y - static_cast<double>(k) * LINE_HEIGHT * letter);
    line.scale.z = letter;
    line.text = lines[k].words;
    markers.markers.push_back(line);
  }
}

MarkerArray baseMarkers(const SceneDefinition& scene, const BaseFrame& base)
{
  const double width = scene.base.width();
  Marker body = marker(base.time, "base", 0, Marker::TRIANGLE_LIST, grey(0.55f));
  Marker outline = marker(base.time, "base", 1, Marker::LINE_LIST, grey(0.2f));
  outline.scale.x = std::min(LINE_WIDTH * width, OUTLINE_WIDTH * scene.base.toothWidth());
  const std::vector<OutlineCorner> corners = scene.base.outline();
  const double bottom = -scene.base.depth();
  for (int tooth = 0; tooth < scene.base.teeth; ++tooth)
    addTooth(corners, tooth * scene.base.toothWidth(), bottom, body, outline);
  addRectangle(body, 0.0, bottom - BEAM_HEIGHT * width, width, BEAM_HEIGHT * width);
  if (scene.boundary == Boundary::WALLED)
    addWalls(scene, body);
  MarkerArray markers;
  markers.markers = {body, outline};
  for (Marker& part : markers.markers)
  {
    part.pose.position = tf2::toMsg(displacementInSpace(base.base));
    part.pose.orientation = tf2::toMsg(inclinationInSpace(base.base));
  }
  return markers;
}

MarkerArray diskMarkers(const SceneDefinition& scene, const ParticleFrame& frame)
{
  MarkerArray markers;
  const DrawnSizes sizes(scene);
  const std::size_t count = sizes.lists.size();
  const auto add = [&](const char* name, std::size_t list, double radius, const std_msgs::ColorRGBA& color)
  {
    Marker spheres = marker(frame.time, name, static_cast<int>(list), Marker::SPHERE_LIST, color);
    spheres.scale.x = spheres.scale.y = spheres.scale.z = 2.0 * radius;
    markers.markers.push_back(spheres);
  };
  for (std::size_t k = 0; k < count; ++k)
    add("disks", k, sizes.lists[k].radius, speciesColor(sizes.lists[k].species));
  for (std::size_t k = 0; k < count; ++k)
    add("dots", k, DOT_RADIUS * sizes.lists[k].radius, grey(1.0f));
  for (const DiskState& disk : frame.disks)
  {
    const double radius = radiusOf(disk, scene.species);
    const std::size_t list = sizes.listOf(disk.species, radius);
    markers.markers[list].points.push_back(planePoint(disk.x, disk.y));
    markers.markers[count + list].points.push_back(dotPoint(disk, radius));
  }
  // RViz reports an empty list as an error.
  for (Marker& spheres : markers.markers)
    if (spheres.points.empty())
      spheres.action = Marker::DELETE;
  return markers;
}

MarkerArray binMarkers(const SceneDefinition& scene, const BinFrame& frame, const BaseFrame& base)
{
  MarkerArray markers;
  if (scene.boundary != Boundary::OPEN)
    return markers;
  const double width = scene.base.width();
  const double inclination = base.base.inclination;
  const double drop = scene.base.depth() + (BIN_HEIGHT + 2.0 * BEAM_HEIGHT) * width;
  const BinPlace left{"left_bin", -(BIN_WIDTH + BIN_GAP) * width, -drop};
  const BinPlace right{"right_bin", width * (std::cos(inclination) + BIN_GAP),
                       width * std::sin(inclination) - drop};
  addBin(scene, frame, left, &SpeciesBins::left, markers);
  addBin(scene, frame, right, &SpeciesBins::right, markers);
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
