#pragma once

#include <cstdint>

namespace ratchet_sieve
{

/// Increases with every change that alters the state or the summary of any scene and seed, even in the last
/// bit. Sweeps store results under this version and reuse results of the same version, whatever the package
/// version. A run can only be resumed under the version that saved it, which a patch of the package does not
/// change. The test PhysicsVersion in test/sweep fails until it is increased.
///
/// 2: runs on a periodic base that turns; runs by steps; the saved state.
/// 3: contacts with level faces in the summary; the saved state.
/// 4: runs on a periodic base that turns.
/// 5: runs with a feed; the separation in the summary; standard errors of short runs; ensembles that
/// collapse.
/// 6: all runs: a disk's flight is kept from the epoch's zero; errors of means over trapped disks; contacts
/// of a flat sawtooth; contacts after a collapse; what is observed before `settle` ends.
constexpr std::int64_t PHYSICS_VERSION = 6;

}  // namespace ratchet_sieve
