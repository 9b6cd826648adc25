#include "ratchet_sieve/scene/canonical_scene.h"

#include <functional>

#include <fmt/format.h>

#include "ratchet_sieve/scene/fnv1a.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{

/// Writes a map in one line: `{name: text, name: text}`.
class FlowMap
{
public:
  void operator()(const char* name, const std::string& text)
  {
    entries_ += (entries_.empty() ? "" : ", ") + std::string(name) + ": " + text;
  }

  template <typename Part>
  FlowMap& add(const Keys<Part>& keys, const Part& part)
  {
    writeValues(keys, part, std::ref(*this));
    return *this;
  }

  bool empty() const { return entries_.empty(); }
  std::string text() const { return '{' + entries_ + '}'; }

private:
  std::string entries_;
};

template <typename Part>
std::string rootLines(const Keys<Part>& keys, const Part& part)
{
  std::string lines;
  writeValues(keys, part,
              [&lines](const char* name, const std::string& text) { lines += name + (": " + text) + '\n'; });
  return lines;
}

std::string section(const std::string& name, const FlowMap& map)
{
  return name + ": " + map.text() + '\n';
}

/// Of keys that are only written where they differ from their defaults: empty if none does.
std::string changedSection(const std::string& name, const FlowMap& map)
{
  return map.empty() ? "" : section(name, map);
}

FlowMap baseMap(const BaseDefinition& base)
{
  FlowMap map;
  writeValues(BASE_KEYS, base,
              [&](const char* name, const std::string& text)
              {
                if (base.profile.empty() || SAWTOOTH_KEYS.count(name) == 0)
                  map(name, text);
              });
  std::string harmonics;
  for (const HarmonicDefinition& harmonic : base.harmonics)
    harmonics += (harmonics.empty() ? "" : ", ") + FlowMap().add(HARMONIC_KEYS, harmonic).text();
  if (!harmonics.empty())
    map("harmonics", '[' + harmonics + ']');
  return map;
}

/// `name:` and a line for each entry, whose map is written by write_entry(entry, map); `name: []` if there
/// are none.
template <typename Entry, typename WriteEntry>
std::string listLines(const std::string& name, const std::vector<Entry>& entries, WriteEntry&& write_entry)
{
  std::string lines = name + (entries.empty() ? ": []\n" : ":\n");
  for (const Entry& entry : entries)
  {
    FlowMap map;
    write_entry(entry, map);
    lines += "  - " + map.text() + '\n';
  }
  return lines;
}

FlowMap feedMap(const SceneDefinition& scene)
{
  FlowMap map;
  map.add(FEED_KEYS, scene.feed);
  std::string disks;
  for (const FedDisk& disk : scene.feed.disks)
  {
    FlowMap one;
    one("species", scalarText(scene.species[disk.species].name));
    disks += (disks.empty() ? "" : ", ") + one.add(FED_KEYS, disk).text();
  }
  if (!disks.empty())
    map("disks", '[' + disks + ']');
  return map;
}

std::string motionYaml(const SceneDefinition& scene)
{
  const auto name_of = [&scene](std::size_t species) { return scalarText(scene.species[species].name); };
  return section("base", baseMap(scene.base)) + rootLines(MOTION_KEYS, scene) +
         listLines("species", scene.species,
                   [](const SpeciesDefinition& species, FlowMap& map)
                   {
                     const SizeDefinition& size = species.size;
                     const bool table = size.distribution == SizeDistribution::TABLE;
                     map.add(SPECIES_KEYS, species).add(COEFFICIENT_KEYS, species.contact);
                     if (size.vary())
                       map("size",
                           FlowMap().add(SIZE_KEYS, size).add(table ? TABLE_KEYS : SPREAD_KEYS, size).text());
                   }) +
         listLines("pairs", scene.pairs,
                   [&](const PairDefinition& pair, FlowMap& map)
                   {
                     map("species", '[' + name_of(pair.first) + ", " + name_of(pair.second) + ']');
                     map.add(COEFFICIENT_KEYS, pair.contact);
                   }) +
         section("contact", FlowMap().add(CONTACT_KEYS, scene.contact)) +
         section("pour", FlowMap().add(POUR_KEYS, scene.pour)) + section("feed", feedMap(scene)) +
         listLines("initial", scene.initial,
                   [&](const InitialDisk& disk, FlowMap& map)
                   {
                     map("species", name_of(disk.species));
                     map.add(INITIAL_KEYS, disk);
                   }) +
         changedSection("height_profile", FlowMap().add(HEIGHT_PROFILE_KEYS, scene.height_profile));
}

}  // namespace

std::string hashText(std::string_view text)
{
  return fmt::format("{:016x}", fnv1a(text));
}

std::string canonicalYaml(const SceneDefinition& scene)
{
  return motionYaml(scene) + rootLines(RUN_KEYS, scene) +
         changedSection("accuracy",
                        FlowMap().add(METHOD_KEYS, scene.accuracy).add(CERTAINTY_KEYS, scene.accuracy));
}

std::string sceneHash(const SceneDefinition& scene)
{
  return hashText(motionYaml(scene) + changedSection("accuracy", FlowMap().add(METHOD_KEYS, scene.accuracy)));
}

std::string runHash(const SceneDefinition& scene)
{
  return hashText(canonicalYaml(scene));
}

}  // namespace ratchet_sieve
