#pragma once

#include <string>
#include <vector>

#include "scene_spoilers.h"
#include "scene_tree.h"

namespace ratchet_sieve
{

/// A map of a scene, and what stands before its keys in an error.
struct PartPlace
{
  SceneTree* map;
  std::string prefix;
};

/// The section, or any entry of the list; made, if it is not there.
PartPlace placeOf(SceneTree& root, const std::string& part);

/// Sees to it that a scene has two species and a pair of them.
void requirePair(SceneTree& root);

/// Sees to it that a scene places its disks by hand.
void requireInitial(SceneTree& root);

/// What breaks a rule across several keys, or is no scene at all.
void addBrokenRules(std::vector<Spoiler>& spoilers);

}  // namespace ratchet_sieve
