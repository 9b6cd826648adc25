#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

namespace ratchet_sieve
{

/// A colour for each species, distinguishable with colour blindness (Okabe & Ito); repeated after eight.
std_msgs::ColorRGBA speciesColor(std::size_t species, float opacity = 1.0f);

std_msgs::ColorRGBA grey(float brightness, float opacity = 1.0f);

/// A point of the plane. @param x to the right [m] @param y up [m]
geometry_msgs::Point planePoint(double x, double y);

/// A marker in frame world, of one colour and unit pose. @param time of its stamp [s]
visualization_msgs::Marker marker(double time, const std::string& name, int id, int type,
                                  const std_msgs::ColorRGBA& color);

/// Adds a rectangle to a TRIANGLE_LIST. @param x, y of its lower left corner [m]
void addRectangle(visualization_msgs::Marker& triangles, double x, double y, double width, double height);

/// Height of a capital letter, in widths of the base.
constexpr double LETTER = 0.024;

/// A line of text.
struct Line
{
  std::string words;
  std_msgs::ColorRGBA color = grey(0.15f);
};

/// The position of the first line of a text.
struct TextPlace
{
  std::string name;  ///< namespace of the markers
  int first_id;
  double x;  ///< middle of each line [m]
  double y;  ///< middle of the first line [m]
};

/// Adds text that faces the viewer, one marker per line: RViz separates lines within a marker by a fixed
/// distance of 1 cm, which does not suit machines of other sizes. @param letter its height [m]
void addLines(double time, const TextPlace& place, double letter, const std::vector<Line>& lines,
              visualization_msgs::MarkerArray& markers);

}  // namespace ratchet_sieve
