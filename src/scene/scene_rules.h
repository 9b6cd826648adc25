#pragma once

#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// Of a ball of a radius [m] [m^3].
double ballVolume(double radius);

/// Determines how many disks of each species are poured: splits a density d = S / W (eq. 1 of the
/// paper) into counts in proportion to the shares, N_k = share_k d W / sum_j(share_j 2 r_j),
/// rounded; pours none where `initial` places them. Warns of counts that are ignored.
/// @throws SceneError
void resolveCounts(const Entry& root, Scene& scene);

/// The rules that join several keys. @throws SceneError
void checkRules(const Entry& root, const SceneDefinition& scene);

}  // namespace ratchet_sieve
