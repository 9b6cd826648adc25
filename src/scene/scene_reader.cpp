#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{

using SpeciesIndex = std::map<std::string, std::size_t>;

/// Reads a map, if there is one. @param others keys that are in none of the tables @return whether there is
/// one
template <typename Part, typename... Tables>
bool readSection(const Entry& root, const std::string& name, Part& part, const std::set<std::string>& others,
                 const Tables&... tables)
{
  if (!root.has(name))
    return false;
  const Entry section = root.at(name);
  std::set<std::string> known = others;
  std::set<std::string> required;
  (known.merge(namesOf(tables)), ...);
  (required.merge(requiredOf(tables)), ...);
  section.requireKeys(known, required);
  (readValues(section, tables, part), ...);
  return true;
}

/// The entries of a list. @param noun of more than one entry
std::vector<Entry> entriesOf(const Entry& list, std::size_t most, const std::string& noun)
{
  std::vector<Entry> entries = list.list();
  if (entries.size() > most)
    list.refuse("must have at most " + std::to_string(most) + ' ' + noun);
  return entries;
}

SizeDefinition readSize(const Entry& entry)
{
  SizeDefinition size;
  const auto& names = namesOf(SIZE_KEYS, namesOf(SPREAD_KEYS, namesOf(TABLE_KEYS)));
  entry.requireKeys(names, requiredOf(SIZE_KEYS));
  readValues(entry, SIZE_KEYS, size);
  const Keys<SizeDefinition>& rest = size.distribution == SizeDistribution::TABLE ? TABLE_KEYS : SPREAD_KEYS;
  entry.requireKeys(namesOf(SIZE_KEYS, namesOf(rest)), requiredOf(rest));
  readValues(entry, rest, size);
  return size;
}

/// The mass of a ball of the species' material.
double massFromDensity(const Entry& entry, double radius)
{
  double density = 0.0;
  readValues(entry, MATERIAL_KEYS, density);
  if (entry.has("mass"))
    entry.at("mass").refuse("must be absent because density gives it");
  const double mass = density * ballVolume(radius);
  if (!massRange().holds(mass))
    entry.at("density").refuseValue("gives a mass of " + scalarText(mass) + " kg; must be a number " +
                                    massRange().text());
  return mass;
}

SpeciesDefinition readSpecies(const Entry& entry, bool count_required)
{
  entry.keys();
  const bool has_density = entry.has("density");
  std::set<std::string> required = requiredOf(SPECIES_KEYS);
  if (count_required)
    required.insert("count");
  if (has_density)
    required.erase("mass");
  const std::set<std::string> known =
      namesOf(SHARE_KEYS, namesOf(MATERIAL_KEYS, namesOf(COEFFICIENT_KEYS, {"size"})));
  entry.requireKeys(namesOf(SPECIES_KEYS, known), required);
  SpeciesDefinition species;
  readValues(entry, SPECIES_KEYS, species);
  if (has_density)
    species.mass = massFromDensity(entry, species.radius);
  readValues(entry, COEFFICIENT_KEYS, species.contact);
  if (entry.has("size"))
    species.size = readSize(entry.at("size"));
  return species;
}

SpeciesIndex readAllSpecies(const Entry& root, bool count_required, SceneDefinition& scene)
{
  SpeciesIndex index;
  for (const Entry& entry : entriesOf(root.at("species"), MOST_SPECIES, "species"))
  {
    scene.species.push_back(readSpecies(entry, count_required));
    if (!index.emplace(scene.species.back().name, index.size()).second)
      entry.at("name").refuseValue("another species has this name already");
  }
  if (index.empty())
    root.at("species").refuse("must have at least one species");
  return index;
}

std::size_t readSpeciesName(const Entry& entry, const SpeciesIndex& index)
{
  std::string name;
  readScalar(entry, {}, name);
  const auto found = index.find(name);
  if (found != index.end())
    return found->second;
  std::string known;
  for (const auto& item : index)
    known += (known.empty() ? "" : ", ") + item.first;
  entry.refuseValue("unknown species; must be one of " + known);
}

PairDefinition readPair(const Entry& entry, const SpeciesIndex& index, const SceneDefinition& scene)
{
  entry.requireKeys(namesOf(COEFFICIENT_KEYS, {"species"}), {"species"});
  const std::vector<Entry> names = entry.at("species").list();
  if (names.size() != 2)
    entry.at("species").refuse("must be a list of two species");
  PairDefinition pair;
  pair.first = readSpeciesName(names[0], index);
  pair.second = readSpeciesName(names[1], index);
  if (pair.first == pair.second)
    entry.at("species").refuse(
        "must be two different species; contacts within a species have its own coefficients");
  pair.contact = contactBetween(scene, pair.first, pair.second);
  readValues(entry, COEFFICIENT_KEYS, pair.contact);
  return pair;
}

void readPairs(const Entry& root, const SpeciesIndex& index, SceneDefinition& scene)
{
  std::vector<PairDefinition> pairs;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  if (root.has("pairs"))
    for (const Entry& entry : root.at("pairs").list())
    {
      pairs.push_back(readPair(entry, index, scene));
      if (!seen.insert(std::minmax(pairs.back().first, pairs.back().second)).second)
        entry.at("species").refuse("another pair has these two species already");
    }
  scene.pairs = std::move(pairs);
}

void readInitial(const Entry& root, const SpeciesIndex& index, SceneDefinition& scene)
{
  if (!root.has("initial"))
    return;
  const std::set<std::string> known = namesOf(INITIAL_KEYS, {"species"});
  const std::set<std::string> required = requiredOf(INITIAL_KEYS, {"species"});
  for (const Entry& entry : root.at("initial").list())
  {
    entry.requireKeys(known, required);
    InitialDisk disk;
    disk.species = readSpeciesName(entry.at("species"), index);
    readValues(entry, INITIAL_KEYS, disk);
    scene.initial.push_back(disk);
  }
}

bool placesDisks(const Entry& root)
{
  return root.has("initial") && !root.at("initial").list().empty();
}

/// As many as fit the length best. @throws SceneError
int teethOf(const Entry& entry, double length, double tooth_width, std::vector<std::string>& warnings)
{
  constexpr double ROUNDING = 1e-9;  ///< of products and quotients of lengths that were written as decimals
  const double teeth = std::round(length / tooth_width);
  if (!teethRange().holds(teeth))
    entry.refuseValue("must be that of " + teethRange().values() + " teeth, each " + scalarText(tooth_width) +
                      " m wide");
  if (std::abs(teeth * tooth_width - length) > ROUNDING * length)
    warnings.push_back(
        withId(fmt::format("base.length = {:.6g} m is rounded to {} teeth of {:.6g} m: {:.6g} m", length,
                           static_cast<int>(teeth), tooth_width, teeth * tooth_width),
               "rounded-length"));
  return static_cast<int>(teeth);
}

void readBase(const Entry& root, Scene& scene)
{
  BaseDefinition& base = scene.definition.base;
  if (!readSection(root, "base", base, namesOf(LENGTH_KEYS, {"harmonics"}), BASE_KEYS))
    return;
  const Entry section = root.at("base");
  for (const Replacement& replacement : baseReplacements())
    for (const std::string& name : replacement.others)
      if (section.has(replacement.key) && section.has(name))
        section.at(name).refuse(std::string("must be absent because base.") + replacement.key + " gives " +
                                replacement.gives);
  double length = 0.0;
  readValues(section, LENGTH_KEYS, length);
  if (section.has("length"))
    base.teeth = teethOf(section.at("length"), length, base.toothWidth(), scene.warnings);
  if (!section.has("harmonics"))
    return;
  for (const Entry& entry : entriesOf(section.at("harmonics"), MOST_HARMONICS, "harmonics"))
  {
    entry.requireKeys(namesOf(HARMONIC_KEYS), requiredOf(HARMONIC_KEYS));
    readValues(entry, HARMONIC_KEYS, base.harmonics.emplace_back());
  }
}

FedDisk readFedDisk(const Entry& entry, const SpeciesIndex& index)
{
  FedDisk disk;
  disk.species = readSpeciesName(entry.at("species"), index);
  readValues(entry, FED_KEYS, disk);
  return disk;
}

bool listsFeed(const Entry& root)
{
  return root.has("feed") && (root.at("feed").has("disks") || root.at("feed").has("file"));
}

/// The disks of feed.disks or feed.file, in the order of time.
void readFeedList(const Entry& root, const SpeciesIndex& index, Scene& scene)
{
  if (!listsFeed(root))
    return;
  const Entry feed = root.at("feed");
  const std::set<std::string> names = namesOf(FED_KEYS, {"species"});
  std::vector<FedDisk>& disks = scene.definition.feed.disks;
  if (feed.has("file"))
    scene.feed_file =
        forEachRow(feed, names, [&](const Entry& row) { disks.push_back(readFedDisk(row, index)); });
  else
    for (const Entry& entry : feed.at("disks").list())
    {
      entry.requireKeys(names, requiredOf(FED_KEYS, {"species"}));
      disks.push_back(readFedDisk(entry, index));
    }
  if (disks.size() > MOST_FED)
    feed.refuse("must have at most " + std::to_string(MOST_FED) + " disks in its list");
  std::stable_sort(disks.begin(), disks.end(),
                   [](const FedDisk& a, const FedDisk& b) { return a.time < b.time; });
}

void readFeed(const Entry& root, FeedDefinition& feed)
{
  if (!readSection(root, "feed", feed, namesOf(FEED_FILE_KEYS, {"disks"}), FEED_KEYS))
    return;
  const Entry section = root.at("feed");
  FeedFile file;
  readValues(section, FEED_FILE_KEYS, file);
  if (section.has("file") && section.has("disks"))
    section.at("disks").refuse("must be absent because feed.file gives the disks");
  if (section.has("side") && !section.has("file"))
    section.at("side").refuse("needs feed.file");
}

void readRoot(const Entry& root, Scene& whole)
{
  SceneDefinition& scene = whole.definition;
  const std::set<std::string> parts = {"base", "species", "pairs",    "contact",       "pour",
                                       "feed", "initial", "accuracy", "height_profile"};
  root.requireKeys(namesOf(MOTION_KEYS, namesOf(DENSITY_KEYS, namesOf(RUN_KEYS, parts))), {"species"});
  readValues(root, MOTION_KEYS, scene);
  readValues(root, RUN_KEYS, scene);
  readBase(root, whole);
  readSection(root, "contact", scene.contact, {}, CONTACT_KEYS);
  readSection(root, "pour", scene.pour, {}, POUR_KEYS);
  readFeed(root, scene.feed);
  readSection(root, "height_profile", scene.height_profile, {}, HEIGHT_PROFILE_KEYS);
  readSection(root, "accuracy", scene.accuracy, {}, METHOD_KEYS, CERTAINTY_KEYS);
}

}  // namespace

Scene sceneFromYaml(const YAML::Node& node, const std::string& source)
{
  try
  {
    Scene scene;
    const Entry root(node, source);
    readRoot(root, scene);
    const bool count_required =
        !root.has("density") && !placesDisks(root) && scene.definition.feed.rate <= 0.0 && !listsFeed(root);
    const SpeciesIndex index = readAllSpecies(root, count_required, scene.definition);
    readPairs(root, index, scene.definition);
    readInitial(root, index, scene.definition);
    readFeedList(root, index, scene);
    resolveCounts(root, scene);
    checkRules(root, scene.definition);
    for (std::string& line : implausibilities(scene.definition))
      scene.warnings.push_back(std::move(line));
    return scene;
  }
  catch (const YAML::Exception& error)
  {
    throw SceneError(source + ": not a scene: " + shownText(error.msg));
  }
}

std::vector<std::string> certaintyKeyNames()
{
  const std::set<std::string> names = namesOf(CERTAINTY_KEYS);
  return {names.begin(), names.end()};
}

}  // namespace ratchet_sieve
