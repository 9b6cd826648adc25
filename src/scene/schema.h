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

/// Every key of a scene that holds one value, in tables: one row serves reading, checking, writing, hashing,
/// suggestions and `sieve_run --keys`.
namespace ratchet_sieve
{

using Slot = std::variant<double*, int*, std::uint64_t*, bool*, std::string*, std::vector<double>*,
                          std::vector<std::string>*, Boundary*, DriveFrame*, CollapseAction*, ChokeAction*,
                          Method*, SizeDistribution*, SizeShare*, std::vector<OutlineCorner>*>;

enum class Presence
{
  OPTIONAL,  ///< has a default, and is always written
  REQUIRED,
  ADDED  ///< optional, and not written at its default: scenes older than the key keep their hash
};

/// One key of a part of the scene.
template <typename Part>
struct Key
{
  const char* name;
  Slot (*slot)(Part&);  ///< where its value is stored
  Range range;
  const char* meaning;  ///< one sentence
  Presence presence = Presence::OPTIONAL;
  const char* default_text = nullptr;  ///< where the default is not the struct's
};

template <typename Part>
using Keys = std::vector<Key<Part>>;

const Keys<SceneDefinition>& motionKeys();  ///< at the root, decide how the disks move
const Keys<SceneDefinition>& runKeys();     ///< at the root, decide only what part of it is run
const Keys<double>& densityKeys();          ///< at the root; not stored, but split into counts
const Keys<BaseDefinition>& baseKeys();
const std::set<std::string>& sawtoothKeys();     ///< those of the base that base.profile replaces
const Keys<HarmonicDefinition>& harmonicKeys();  ///< of an entry of base.harmonics
const Keys<SpeciesDefinition>& speciesKeys();
const Keys<double>& materialKeys();        ///< of a species; not stored, but turned into its mass
const Keys<SizeDefinition>& sizeKeys();    ///< of a species' size
const Keys<SizeDefinition>& spreadKeys();  ///< of one with a spread
const Keys<SizeDefinition>& tableKeys();   ///< of one with a table
const Keys<ContactCoefficients>& coefficientKeys();
const Keys<ContactDefinition>& contactKeys();
const Keys<PourDefinition>& pourKeys();
const Keys<FeedDefinition>& feedKeys();
const Keys<HeightProfileDefinition>& heightProfileKeys();
const Keys<InitialDisk>& initialKeys();
const Keys<AccuracyDefinition>& methodKeys();     ///< of accuracy, decide how the disks move
const Keys<AccuracyDefinition>& certaintyKeys();  ///< of accuracy, decide only what part of it is run

/// Of the mass of a disk.
Range massRange();

constexpr double SMALLEST_LENGTH = 1e-9;  ///< of any part of a scene [m]

/// Most harmonics of a drive: each evaluation of the base's motion sums all of them.
constexpr std::size_t MOST_HARMONICS = 64;

/// Most radii that a table of sizes may have.
constexpr std::size_t MOST_SIZES = 1000;

/// Most species that a scene may have: tables of pairs grow with its square.
constexpr std::size_t MOST_SPECIES = 256;

/// The names of the keys, added to those given.
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
    if (key.presence == Presence::REQUIRED)
      names.insert(key.name);
  return names;
}

/// Reads the keys that the map has. @throws SceneError for a bad value
template <typename Part>
void readValues(const Entry& map, const Keys<Part>& keys, Part& part)
{
  for (const Key<Part>& key : keys)
    if (map.has(key.name))
      std::visit([&](auto* value) { readScalar(map.at(key.name), key.range, *value); }, key.slot(part));
}

/// The text of a key's value, as it is written.
template <typename Part>
std::string valueText(const Key<Part>& key, Part& part)
{
  return std::visit([](const auto* value) { return scalarText(*value); }, key.slot(part));
}

/// Calls write(name, text) for every key, except for added ones that have their default.
template <typename Part, typename Write>
void writeValues(const Keys<Part>& keys, Part part, Write&& write)
{
  Part plain{};
  for (const Key<Part>& key : keys)
    if (key.presence != Presence::ADDED || valueText(key, part) != valueText(key, plain))
      write(key.name, valueText(key, part));
}

}  // namespace ratchet_sieve
