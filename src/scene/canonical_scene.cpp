#include "ratchet_sieve/scene/canonical_scene.h"

#include <cstdio>
#include <functional>
#include <initializer_list>
#include <sstream>

#include "ratchet_sieve/core/fnv1a.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{

/// Writes a flow map's values: `name: text, name: text`.
class FlowWriter
{
public:
  explicit FlowWriter(std::ostream& out) : out_(out) {}

  void operator()(const char* name, const std::string& text)
  {
    out_ << (first_ ? "" : ", ") << name << ": " << text;
    first_ = false;
  }

private:
  std::ostream& out_;
  bool first_ = true;
};

template <typename Part>
void writeRoot(std::ostream& out, const Keys<Part>& keys, const Part& part)
{
  writeValues(keys, part,
              [&out](const char* name, const std::string& text) { out << name << ": " << text << '\n'; });
}

template <typename Part>
void writeSection(std::ostream& out, const char* name, const Keys<Part>& keys, const Part& part)
{
  out << name << ": {";
  writeValues(keys, part, FlowWriter(out));
  out << "}\n";
}

/// The keys of a section that differ from their defaults; empty if none does.
template <typename Part>
std::string changedSection(const char* name, const Part& part,
                           std::initializer_list<const Keys<Part>*> key_lists)
{
  std::ostringstream out;
  FlowWriter flow(out);
  for (const Keys<Part>* keys : key_lists)
    writeValues(*keys, part, std::ref(flow));
  return out.str().empty() ? "" : name + (": {" + out.str()) + "}\n";
}

/// `[{...}, {...}]`
template <typename Part>
std::string flowList(const Keys<Part>& keys, const std::vector<Part>& parts)
{
  std::ostringstream out;
  for (const Part& part : parts)
  {
    out << (out.tellp() == 0 ? "[{" : ", {");
    writeValues(keys, part, FlowWriter(out));
    out << '}';
  }
  out << ']';
  return out.str();
}

void writeBase(std::ostream& out, const BaseDefinition& base)
{
  FlowWriter flow(out);
  out << "base: {";
  writeValues(baseKeys(), base,
              [&](const char* name, const std::string& text)
              {
                if (base.profile.empty() || sawtoothKeys().count(name) == 0)
                  flow(name, text);
              });
  if (!base.harmonics.empty())
    flow("harmonics", flowList(harmonicKeys(), base.harmonics));
  out << "}\n";
}

/// `name:` and one line for each entry, written by write_entry(entry, flow); `name: []` for an empty list.
template <typename Entry, typename WriteEntry>
void writeList(std::ostream& out, const char* name, const std::vector<Entry>& entries,
               WriteEntry&& write_entry)
{
  out << name << (entries.empty() ? ": []\n" : ":\n");
  for (const Entry& entry : entries)
  {
    out << "  - {";
    write_entry(entry, FlowWriter(out));
    out << "}\n";
  }
}

std::string sizeText(const SizeDefinition& size)
{
  std::ostringstream out;
  FlowWriter flow(out);
  writeValues(sizeKeys(), size, std::ref(flow));
  const bool table = size.distribution == SizeDistribution::TABLE;
  writeValues(table ? tableKeys() : spreadKeys(), size, std::ref(flow));
  return '{' + out.str() + '}';
}

std::string motionYaml(const SceneDefinition& scene)
{
  std::ostringstream out;
  writeBase(out, scene.base);
  writeRoot(out, motionKeys(), scene);
  writeList(out, "species", scene.species,
            [](const SpeciesDefinition& species, FlowWriter flow)
            {
              writeValues(speciesKeys(), species, std::ref(flow));
              writeValues(coefficientKeys(), species.contact, std::ref(flow));
              if (species.size.vary())
                flow("size", sizeText(species.size));
            });
  writeList(out, "pairs", scene.pairs,
            [&scene](const PairDefinition& pair, FlowWriter flow)
            {
              flow("species", '[' + scalarText(scene.species[pair.first].name) + ", " +
                                  scalarText(scene.species[pair.second].name) + ']');
              writeValues(coefficientKeys(), pair.contact, std::ref(flow));
            });
  writeSection(out, "contact", contactKeys(), scene.contact);
  writeSection(out, "pour", pourKeys(), scene.pour);
  writeSection(out, "feed", feedKeys(), scene.feed);
  writeList(out, "initial", scene.initial,
            [&scene](const InitialDisk& disk, FlowWriter flow)
            {
              flow("species", scalarText(scene.species[disk.species].name));
              writeValues(initialKeys(), disk, std::ref(flow));
            });
  out << changedSection("height_profile", scene.height_profile, {&heightProfileKeys()});
  return out.str();
}

std::string hashText(const std::string& text)
{
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(fnv1a(text)));
  return digits;
}

}  // namespace

std::string canonicalYaml(const SceneDefinition& scene)
{
  std::ostringstream out;
  out << motionYaml(scene);
  writeRoot(out, runKeys(), scene);
  out << changedSection("accuracy", scene.accuracy, {&methodKeys(), &certaintyKeys()});
  return out.str();
}

std::string sceneHash(const SceneDefinition& scene)
{
  return hashText(motionYaml(scene) + changedSection("accuracy", scene.accuracy, {&methodKeys()}));
}

std::string runHash(const SceneDefinition& scene)
{
  return hashText(canonicalYaml(scene));
}

}  // namespace ratchet_sieve
