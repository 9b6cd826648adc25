#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "ratchet_sieve/live/picture.h"

/// The machine as RViz draws it. All markers stand in frame world, in its plane y = 0, so that a view
/// along y shows true sizes and true contacts, and so that no transform is needed to draw them.
namespace ratchet_sieve
{

/// All of the markers below.
visualization_msgs::MarkerArray pictureMarkers(const Picture& picture);

/// The base: teeth and the beam that carries them.
visualization_msgs::MarkerArray baseMarkers(const SceneDefinition& scene, const BaseFrame& base);

/// The disks: one SPHERE_LIST a species, in true size; then one a species of the dots that show how they
/// turn.
visualization_msgs::MarkerArray diskMarkers(const SceneDefinition& scene, const ParticleFrame& frame);

/// The bins of an open base, at rest: boxes that fill, with counts. Nothing for other boundaries.
visualization_msgs::MarkerArray binMarkers(const SceneDefinition& scene, const BinFrame& frame,
                                           const BaseFrame& base);

/// How high the caption begins, over the left end of a base of this inclination [widths of the base]: a steep
/// one pushes it up.
double captionHeight(double inclination);

/// Time, theta, f and A (with their setpoints, while they are on the way), Q and P above the machine; each
/// species' name, size, number and mean velocity with its standard error below it, in its colour.
visualization_msgs::MarkerArray captionMarkers(const Picture& picture);

}  // namespace ratchet_sieve
