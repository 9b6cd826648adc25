#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include "ratchet_sieve/live/run_mirror.h"

/// RViz markers of the machine. All markers are in frame world, in the plane y = 0: a view along y shows true
/// sizes and true contacts, and no transform is needed.
namespace ratchet_sieve
{

/// All of the markers below.
visualization_msgs::MarkerArray pictureMarkers(const Picture& picture);

/// The base: teeth and the beam that carries them.
visualization_msgs::MarkerArray baseMarkers(const SceneDefinition& scene, const BaseFrame& base);

/// The disks: one SPHERE_LIST per species, in true size; then one per species with dots that show the
/// rotation.
visualization_msgs::MarkerArray diskMarkers(const SceneDefinition& scene, const ParticleFrame& frame);

/// The bins of an open base, at rest: boxes with a fill level and counts. Nothing for other boundaries.
visualization_msgs::MarkerArray binMarkers(const SceneDefinition& scene, const BinFrame& frame,
                                           const BaseFrame& base);

/// Height of the caption above the left end of a base at this inclination [widths of the base]: above most
/// disks that the drive of the scene throws up.
double captionHeight(const SceneDefinition& scene, double inclination);

/// Above the machine: time, theta, f and A (with their setpoints while they change), the sieve, Q and P.
/// Below it, in each species' colour: name, size, number and mean velocity with its standard error.
visualization_msgs::MarkerArray captionMarkers(const Picture& picture);

/// A colour for each species, distinguishable with colour blindness (Okabe & Ito); repeated after eight.
std_msgs::ColorRGBA speciesColor(std::size_t species);

std_msgs::ColorRGBA grey(float brightness);

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
