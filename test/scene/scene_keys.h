#pragma once

#include <string>
#include <vector>

namespace ratchet_sieve
{

enum class ValueKind
{
  NUMBER,
  INTEGER,
  SEED,  ///< any whole number of 64 bits
  TRUTH,
  WORD,  ///< one of a few
  NAME,
  SPECIES,      ///< the name of a species
  TWO_SPECIES,  ///< a list of the names of two
};

/// One key of a scene as this test knows it, apart from the reader's own tables: a range that slips there is
/// found here. A test holds the list against a scene that is written out in full, so that no key is
/// forgotten.
struct SceneKey
{
  std::string part;  ///< the section or list that it is in; empty at the root
  std::string name;
  ValueKind kind;
  double lowest = 0.0;
  double highest = 0.0;
  bool required = false;
  std::vector<std::string> words = {};
};

const std::vector<SceneKey>& sceneKeys();

/// The parts that are lists of maps; every other is a map.
inline bool isList(const std::string& part)
{
  return part == "species" || part == "pairs" || part == "initial";
}

}  // namespace ratchet_sieve
