#pragma once

#include <string>
#include <string_view>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// 16 hexadecimal digits: FNV-1a of the bytes, 64 bits.
std::string hashText(std::string_view bytes);

/// The scene as YAML with every key; doubles are written so that they read back bit for bit.
std::string canonicalYaml(const SceneDefinition& scene);

/// hashText() over every key that decides the disks' motion: all but `seed`,
/// `duration`, `settle` and the keys that decide when a run may end.
std::string sceneHash(const SceneDefinition& scene);

/// hashText() over every key, including those that sceneHash() leaves out: only identical runs
/// have the same.
std::string runHash(const SceneDefinition& scene);

}  // namespace ratchet_sieve
