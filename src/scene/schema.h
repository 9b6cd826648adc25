#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/scalars.h"
#include "ratchet_sieve/scene/scene_file.h"

/// Every key of a scene that holds one value, in tables: one row serves reading, checking, writing, hashing,
/// suggestions, the search for wrong units and `sieve_run --keys`.
namespace ratchet_sieve
{

using Slot =
    std::variant<double*, int*, std::uint64_t*, bool*, std::string*, std::vector<double>*,
                 std::vector<std::string>*, Boundary*, DriveFrame*, CollapseAction*, ChokeAction*, Method*,
                 SizeDistribution*, SizeShare*, std::vector<OutlineCorner>*, FilePath*, FeedSide*>;

/// Where a feed's list is read from. It is not stored: the scene holds the list.
struct FeedFile
{
  FilePath path;
  FeedSide side = FeedSide::BOTH;
};

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

extern const Keys<SceneDefinition> MOTION_KEYS;  ///< at the root, decide how the disks move
extern const Keys<SceneDefinition> RUN_KEYS;     ///< at the root, decide only what part of it is run
extern const Keys<double> DENSITY_KEYS;          ///< at the root; not stored, but split into counts
extern const Keys<BaseDefinition> BASE_KEYS;
extern const Keys<double> LENGTH_KEYS;  ///< of the base; not stored, but turned into its number of teeth
extern const std::set<std::string> SAWTOOTH_KEYS;     ///< those of the base that base.profile replaces
extern const Keys<HarmonicDefinition> HARMONIC_KEYS;  ///< of an entry of base.harmonics
extern const Keys<SpeciesDefinition> SPECIES_KEYS;
extern const Keys<SizeShare> SHARE_KEYS;        ///< of a species; not stored: shares become those by number
extern const Keys<double> MATERIAL_KEYS;        ///< of a species; not stored, but turned into its mass
extern const Keys<SizeDefinition> SIZE_KEYS;    ///< of a species' size
extern const Keys<SizeDefinition> SPREAD_KEYS;  ///< of one with a spread
extern const Keys<SizeDefinition> TABLE_KEYS;   ///< of one with a table
extern const Keys<ContactCoefficients> COEFFICIENT_KEYS;
extern const Keys<ContactDefinition> CONTACT_KEYS;
extern const Keys<PourDefinition> POUR_KEYS;
extern const Keys<FeedDefinition> FEED_KEYS;
extern const Keys<FeedFile> FEED_FILE_KEYS;  ///< of feed
extern const Keys<FedDisk> FED_KEYS;         ///< of feed.disks, and columns of feed.file
extern const Keys<HeightProfileDefinition> HEIGHT_PROFILE_KEYS;
extern const Keys<InitialDisk> INITIAL_KEYS;
extern const Keys<AccuracyDefinition> METHOD_KEYS;     ///< of accuracy, decide how the disks move
extern const Keys<AccuracyDefinition> CERTAINTY_KEYS;  ///< of accuracy, decide only what part of it is run

/// Of the mass of a disk.
Range massRange();

/// Of the number of teeth.
Range teethRange();

/// A key of the base that stands in place of others.
struct Replacement
{
  const char* key;
  std::set<std::string> others;
  const char* gives;
};
const std::vector<Replacement>& baseReplacements();

constexpr double SMALLEST_LENGTH = 1e-9;  ///< of any part of a scene [m]

/// Most harmonics of a drive: each evaluation of the base's motion sums all of them.
constexpr std::size_t MOST_HARMONICS = 64;

/// Most radii that a table of sizes may have.
constexpr std::size_t MOST_SIZES = 1000;

/// Most species that a scene may have: tables of pairs grow with its square.
constexpr std::size_t MOST_SPECIES = 256;

/// Most disks that a feed's list may have: its text is a part of checkpoints and bags, and is read back.
constexpr std::size_t MOST_FED = 50000;

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

/// @param part of the scene, such as base; empty at the root @param unit of the number's key
using VisitNumber = std::function<void(const std::string& part, const char* unit, double& number)>;

/// Visits each number that is not an integer, to read it or to change it; of lists each number.
void forEachNumber(SceneDefinition& scene, const VisitNumber& visit);

/// Visits each row of feed.file, those of feed.side alone if it is given. A row is a map whose errors name
/// file and line.
/// @param columns that the rows have @return the file's path @throws SceneError
std::string forEachRow(const Entry& feed, const std::set<std::string>& columns,
                       const std::function<void(const Entry&)>& visit);

/// Of a ball of a radius [m] [m^3].
double ballVolume(double radius);

/// Turns shares by mass into shares by number, then determines how many disks of each species are poured:
/// splits a density d = S / W (eq. 1 of the paper) into counts in proportion to the shares, N_k = share_k d W
/// / sum_j(share_j 2 r_j), rounded; pours none where `initial` places them. Warns of counts that are ignored.
/// @throws SceneError
void resolveCounts(const Entry& root, Scene& scene);

/// The rules that join several keys. @throws SceneError
void checkRules(const Entry& root, const SceneDefinition& scene);

}  // namespace ratchet_sieve
