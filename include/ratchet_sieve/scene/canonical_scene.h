#pragma once

#include <string>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// The scene as YAML with every key written out, doubles so that they read back bit for bit.
std::string canonicalYaml(const SceneDefinition& scene);

/// 16 hexadecimal digits (FNV-1a, 64 bits) over all that decides the disks' motion: every key but
/// `seed`, `duration` and `settle`.
std::string sceneHash(const SceneDefinition& scene);

/// 16 hexadecimal digits over every key, those that sceneHash() leaves out as well: the same for the same run
/// alone.
std::string runHash(const SceneDefinition& scene);

}  // namespace ratchet_sieve
