#pragma once

#include <vector>

#include <sensor_msgs/PointCloud2.h>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// The disks as a point cloud in frame world: x, y (0), z, radius [m, float32] and species (index, uint32).
/// For the display of very many disks; ParticleStates carries the full state.
/// @param species of the frame's scene
sensor_msgs::PointCloud2 particleCloud(const ParticleFrame& frame,
                                       const std::vector<SpeciesDefinition>& species);

}  // namespace ratchet_sieve
