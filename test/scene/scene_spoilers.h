#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "random_scene.h"
#include "scene_tree.h"

namespace ratchet_sieve
{

/// What a refusal must say.
struct Expected
{
  std::string key;    ///< dotted; empty where the text is no scene at all
  std::string value;  ///< as the scene has it; empty where no value is wrong
  std::string hint;   ///< a word more, such as the key that was meant
};

/// One way to spoil a scene, which was legal before and has nothing else wrong after.
struct Spoiler
{
  std::string way;
  std::function<Expected(SceneTree&)> spoil;
};

/// Every wrong value and every wrong shape of every key, every part and every rule.
const std::vector<Spoiler>& sceneSpoilers();

/// The ways in which the place of a disk of `initial` can be wrong, which the engine sees.
enum class Misplaced
{
  OVERLAPPING,
  BURIED,
  OUTSIDE
};

/// A scene that reads well and cannot start.
struct MisplacedScene
{
  RandomScene scene;
  std::vector<std::string> words;  ///< that the refusal must have
};

inline std::ostream& operator<<(std::ostream& out, const MisplacedScene& misplaced)
{
  return out << misplaced.scene;
}

MisplacedScene drawnMisplacedScene(Misplaced how);

}  // namespace ratchet_sieve
