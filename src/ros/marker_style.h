#pragma once

#include <string>

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

namespace ratchet_sieve
{

/// A colour for each species, told apart by the colour-blind too (Okabe & Ito), over again after eight.
std_msgs::ColorRGBA speciesColor(std::size_t species, float opacity = 1.0f);

std_msgs::ColorRGBA grey(float brightness, float opacity = 1.0f);

/// A point of the plane. @param x to the right [m] @param y up [m]
geometry_msgs::Point planePoint(double x, double y);

/// A marker in frame world, of one colour and unit pose. @param time of its stamp [s]
visualization_msgs::Marker marker(double time, const std::string& name, int id, int type,
                                  const std_msgs::ColorRGBA& color);

/// Adds a rectangle to a TRIANGLE_LIST. @param x, y of its lower left corner [m]
void addRectangle(visualization_msgs::Marker& triangles, double x, double y, double width, double height);

/// Text that faces the viewer, centred on (x, y). @param size of a capital letter [m]
visualization_msgs::Marker text(double time, const std::string& name, int id, double x, double y, double size,
                                const std::string& words, const std_msgs::ColorRGBA& color = grey(0.15f));

}  // namespace ratchet_sieve
