#include "marker_style.h"

#include <array>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
using Rgb = std::array<float, 3>;
constexpr std::array<Rgb, 8> PALETTE = {Rgb{0.000f, 0.447f, 0.698f}, Rgb{0.835f, 0.369f, 0.000f},
                                        Rgb{0.000f, 0.620f, 0.451f}, Rgb{0.902f, 0.624f, 0.000f},
                                        Rgb{0.800f, 0.475f, 0.655f}, Rgb{0.337f, 0.706f, 0.914f},
                                        Rgb{0.941f, 0.894f, 0.259f}, Rgb{0.200f, 0.200f, 0.200f}};

constexpr double LINE_HEIGHT = 1.5;  // in letters
}  // namespace

std_msgs::ColorRGBA speciesColor(std::size_t species, float opacity)
{
  const Rgb& rgb = PALETTE[species % PALETTE.size()];
  std_msgs::ColorRGBA color;
  color.r = rgb[0];
  color.g = rgb[1];
  color.b = rgb[2];
  color.a = opacity;
  return color;
}

std_msgs::ColorRGBA grey(float brightness, float opacity)
{
  std_msgs::ColorRGBA color;
  color.r = color.g = color.b = brightness;
  color.a = opacity;
  return color;
}

geometry_msgs::Point planePoint(double x, double y)
{
  geometry_msgs::Point point;
  point.x = x;
  point.z = y;
  return point;
}

visualization_msgs::Marker marker(double time, const std::string& name, int id, int type,
                                  const std_msgs::ColorRGBA& color)
{
  visualization_msgs::Marker marker;
  marker.header.stamp = stampOf(time);
  marker.header.frame_id = WORLD_FRAME_ID;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color = color;
  return marker;
}

void addRectangle(visualization_msgs::Marker& triangles, double x, double y, double width, double height)
{
  const auto lower_left = planePoint(x, y);
  const auto lower_right = planePoint(x + width, y);
  const auto upper_left = planePoint(x, y + height);
  const auto upper_right = planePoint(x + width, y + height);
  for (const auto& corner : {lower_left, lower_right, upper_right, lower_left, upper_right, upper_left})
    triangles.points.push_back(corner);
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

}  // namespace ratchet_sieve
