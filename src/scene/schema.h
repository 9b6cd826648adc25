#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/range.h"
#include "ratchet_sieve/scene/scalars.h"

/// Every key of a scene that holds one value, in tables: they are what is read, checked, written
/// and suggested.
namespace ratchet_sieve
{

using Slot =
    std::variant<double*, int*, std::uint64_t*, bool*, std::string*, Boundary*, CollapseAction*, Method*>;

/// One key of a part of the scene.
template <typename Part>
struct Key
{
  const char* name;
  Slot (*slot)(Part&);  ///< where its value lives
  Range range;
  bool required = false;
  bool written_at_default = true;  ///< false for a key that came later: scenes without it keep their hash
};

template <typename Part>
using Keys = std::vector<Key<Part>>;

const Keys<SceneDefinition>& motionKeys();  ///< at the root, decide how the disks move
const Keys<SceneDefinition>& runKeys();     ///< at the root, decide only what part of it is run
const Keys<BaseDefinition>& baseKeys();
const Keys<HarmonicDefinition>& harmonicKeys();  ///< of an entry of base.harmonics
const Keys<SpeciesDefinition>& speciesKeys();
const Keys<ContactCoefficients>& coefficientKeys();
const Keys<ContactDefinition>& contactKeys();
const Keys<PourDefinition>& pourKeys();
const Keys<FeedDefinition>& feedKeys();
const Keys<InitialDisk>& initialKeys();
const Keys<AccuracyDefinition>& methodKeys();     ///< of accuracy, decide how the disks move
const Keys<AccuracyDefinition>& certaintyKeys();  ///< of accuracy, decide only what part of it is run

/// Allowed for `density`, which is not kept but split into counts.
Range densityRange();

/// Most disks that a scene may have.
constexpr int MOST_DISKS = 10'000'000;

/// Most harmonics of a drive: all of them are summed up wherever the base is evaluated.
constexpr std::size_t MOST_HARMONICS = 64;

/// Most species that a scene may have: tables of their pairs grow with the square.
constexpr std::size_t MOST_SPECIES = 256;

/// The names of the keys, after those given.
template <typename Part>
std::set<std::string> namesOf(const Keys<Part>& keys, std::set<std::string> names = {})
{
  for (const Key<Part>& key : keys)
    names.insert(key.name);
  return names;
}

template <typename Part>
std::set<std::string> requiredOf(const Keys<Part>& keys, std::set<std::string> names = {})
{
  for (const Key<Part>& key : keys)
    if (key.required)
      names.insert(key.name);
  return names;
}

/// Reads those of the keys that the map has. @throws SceneError for a bad value
template <typename Part>
void readValues(const Entry& map, const Keys<Part>& keys, Part& part)
{
  for (const Key<Part>& key : keys)
    if (map.has(key.name))
      std::visit([&](auto* value) { readScalar(map.at(key.name), key.range, *value); }, key.slot(part));
}

/// Calls write(name, text) for every key, but for those that came later and have their default.
template <typename Part, typename Write>
void writeValues(const Keys<Part>& keys, Part part, Write&& write)
{
  const auto text = [](const Key<Part>& key, Part& of)
  { return std::visit([](const auto* value) { return scalarText(*value); }, key.slot(of)); };
  Part plain;
  for (const Key<Part>& key : keys)
    if (key.written_at_default || text(key, part) != text(key, plain))
      write(key.name, text(key, part));
}

}  // namespace ratchet_sieve
