#include "ratchet_sieve/recording/checkpoint.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"

// The file: a line with its type, and the bytes of saveRun(): a line with the checksum of the rest, a line of
// JSON that identifies the run, and the simulation's state.
namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

/// Incremented with every change of the file format; the state's format depends on the physics version.
constexpr std::string_view FORMAT = "9";
constexpr std::string_view TYPE = "ratchet_sieve checkpoint ";

constexpr std::size_t CHECKSUM_DIGITS = 16;

/// Depends on the order of the bytes.
constexpr std::uint32_t BYTE_ORDER_MARK = 0x01020304;

std::string byteOrder()
{
  return std::string(reinterpret_cast<const char*>(&BYTE_ORDER_MARK), 1) == "\x01" ? "big" : "little";
}

/// What of a scene must match for a run to be resumed, as YAML.
std::string decisiveYaml(SceneDefinition scene)
{
  const AccuracyDefinition accuracy = scene.accuracy;
  scene.accuracy = AccuracyDefinition();
  scene.accuracy.method = accuracy.method;
  scene.accuracy.step = accuracy.step;
  scene.duration = 0.0;
  return canonicalYaml(scene);
}

Json identity(const SceneDefinition& scene)
{
  Json json;
  json["version"] = version();
  json["physics"] = PHYSICS_VERSION;
  json["byte_order"] = byteOrder();
  json["scene"] = decisiveYaml(scene);
  return json;
}

std::string shownValue(const YAML::Node& node)
{
  return node.IsDefined() ? shownText(YAML::Dump(node)) : "absent";
}

/// The first key in which a scene differs from a saved one, and both values, in words; empty if none does.
/// @param key dotted, such as species.0.radius
std::string differenceOf(const std::string& key, const YAML::Node& saved, const YAML::Node& present)
{
  std::string found;
  const auto compare = [&](const auto& part, const std::string& name)
  {
    if (found.empty())
      found = differenceOf(key.empty() ? name : key + '.' + name, saved[part], present[part]);
  };
  const bool comparable = saved.IsDefined() && present.IsDefined() && saved.Type() == present.Type();
  if (!comparable || saved.Scalar() != present.Scalar())
    return "its " + key + " is " + shownValue(saved) + ", but this scene's is " + shownValue(present);
  if (saved.IsMap())
    for (const YAML::Node& map : {saved, present})
      for (const auto& item : map)
        compare(item.first.Scalar(), item.first.Scalar());
  if (saved.IsSequence())
    for (std::size_t k = 0; k < std::max(saved.size(), present.size()); ++k)
      compare(k, std::to_string(k));
  return found;
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason)
{
  throw CheckpointError(path + ": cannot be resumed from: " + reason);
}

std::string readAll(const std::string& path)
{
  if (const auto why = whyUnreadable(path))
    refuse(path, *why);
  if (!std::filesystem::is_regular_file(path))
    refuse(path, "it is no regular file");
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What follows the line with the type.
std::string_view savedPart(const std::string& path, std::string_view file)
{
  if (file.substr(0, TYPE.size()) != TYPE)
    refuse(path, "it is no checkpoint");
  const std::size_t end = std::min(file.find('\n'), file.size());
  const std::string_view format = file.substr(TYPE.size(), end - TYPE.size());
  if (format != FORMAT)
    refuse(path, fmt::format("its format is {}, but ratchet_sieve {} reads {}",
                             shownText(std::string(format)), version(), FORMAT));
  return file.substr(std::min(end + 1, file.size()));
}

/// What of an item of identity() must match: of the version, all but the patch.
std::string decisiveText(const std::string& key, const Json& item)
{
  const std::string text = item.dump();
  return key == "version" ? text.substr(0, text.rfind('.')) : text;
}

/// @throws StateError
void requireSame(const Json& saved, const Json& wanted)
{
  for (const char* key : {"version", "physics", "byte_order"})
    if (decisiveText(key, saved.at(key)) != decisiveText(key, wanted.at(key)))
      throw StateError(std::string("its ") + key + " is " + saved.at(key).dump() +
                       ", but this program's is " + wanted.at(key).dump());
  if (saved.at("scene") == wanted.at("scene"))
    return;
  const std::string different = differenceOf("", copyableYaml(saved.at("scene"), "the saved scene"),
                                             copyableYaml(wanted.at("scene"), "this scene"));
  if (!different.empty())
    throw StateError(different);
}

std::string saveRun(const Simulation& simulation, Json header)
{
  header.update(identity(simulation.scene()));
  const std::string content = header.dump() + '\n' + simulation.saveState();
  return hashText(content) + '\n' + content;
}

/// @throws StateError
Simulation restoreRun(std::string_view saved, const SceneDefinition& scene, Json& header)
{
  const std::string_view content = saved.substr(std::min(saved.size(), CHECKSUM_DIGITS + 1));
  if (content.empty() || saved.substr(0, CHECKSUM_DIGITS) != hashText(content))
    throw StateError("it is damaged");
  const std::size_t end = content.find('\n');
  header = Json::parse(content.substr(0, end));
  requireSame(header, identity(scene));
  return {scene, content.substr(end + 1)};
}

}  // namespace

std::string saveRun(const Simulation& simulation)
{
  return saveRun(simulation, Json::object());
}

Simulation restoreRun(std::string_view saved, const SceneDefinition& scene)
{
  Json header;
  return restoreRun(saved, scene, header);
}

void writeCheckpoint(const std::string& path, const Simulation& simulation, const RunProgress& progress)
{
  const std::string saved = saveRun(simulation, {{"time", simulation.time()},
                                                 {"energy_start", progress.energy_start},
                                                 {"through_base", progress.through_base}});
  AtomicFile file(path);
  file.stream() << TYPE << FORMAT << '\n';
  file.stream().write(saved.data(), static_cast<std::streamsize>(saved.size()));
  file.commit();
}

Checkpoint readCheckpoint(const std::string& path, const SceneDefinition& scene)
{
  const std::string file = readAll(path);
  const std::string_view saved = savedPart(path, file);
  try
  {
    Json header;
    Simulation simulation = restoreRun(saved, scene, header);
    const RunProgress progress{header.at("energy_start"), header.at("through_base")};
    Checkpoint checkpoint{progress, std::move(simulation)};
    if (scene.duration < checkpoint.simulation.time())
      refuse(path, "it is at " + header.at("time").dump() + " s, beyond this run's duration");
    return checkpoint;
  }
  catch (const StateError& error)
  {
    refuse(path, error.what());
  }
}

}  // namespace ratchet_sieve
