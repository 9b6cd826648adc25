#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

/// The machine as RViz draws it. All markers stand in the plane y = 0, so that a view along y shows
/// true sizes and true contacts.
namespace ratchet_sieve
{

/// The base: teeth and the beam that carries them, in frame sieve_base.
visualization_msgs::MarkerArray baseMarkers(const SceneDefinition& scene, double time);

/// The disks, in frame world: one SPHERE_LIST a species, in true size.
visualization_msgs::MarkerArray diskMarkers(const SceneDefinition& scene, const ParticleFrame& frame);

/// The bins of an open base, in frame world at rest: boxes that fill, with counts. Nothing for other
/// boundaries.
visualization_msgs::MarkerArray binMarkers(const SceneDefinition& scene, const BinFrame& frame,
                                           const DriveState& base);

/// Time, theta, f, A, Q and P as text above the machine, in frame world.
visualization_msgs::MarkerArray captionMarkers(const SceneDefinition& scene, const BinFrame& frame,
                                               const DriveState& base);

}  // namespace ratchet_sieve
