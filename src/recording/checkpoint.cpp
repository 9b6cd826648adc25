#include "ratchet_sieve/recording/checkpoint.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/fnv1a.h"
#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/input_file.h"

// The file: a line with its type, a line with the checksum of the rest, a line of JSON that identifies the
// run, and the simulation's state.
namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

/// Incremented with every change of the file format; the state's format depends on the physics version.
constexpr std::string_view FIRST_LINE = "ratchet_sieve checkpoint 8\n";
constexpr std::string_view ANY_FIRST_LINE = "ratchet_sieve checkpoint ";

constexpr std::size_t CHECKSUM_DIGITS = 16;

/// Depends on the order of the bytes.
constexpr std::uint32_t BYTE_ORDER_MARK = 0x01020304;

std::string checksum(std::string_view bytes)
{
  char digits[CHECKSUM_DIGITS + 1];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(fnv1a(bytes)));
  return digits;
}

std::string byteOrder()
{
  return std::string(reinterpret_cast<const char*>(&BYTE_ORDER_MARK), 1) == "\x01" ? "big" : "little";
}

/// All that must match for a run to be resumed.
Json identity(const SceneDefinition& scene)
{
  Json json;
  json["version"] = version();
  json["physics"] = PHYSICS_VERSION;
  json["byte_order"] = byteOrder();
  json["scene_hash"] = sceneHash(scene);
  json["seed"] = scene.seed;
  json["settle"] = scene.settle;
  return json;
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

/// The content after the checksum. @throws if the checksum is wrong
std::string_view checkedContent(const std::string& path, std::string_view file)
{
  if (file.substr(0, ANY_FIRST_LINE.size()) != ANY_FIRST_LINE)
    refuse(path, "it is no checkpoint");
  if (file.substr(0, FIRST_LINE.size()) != FIRST_LINE)
    refuse(path, "it is of another format than " + std::string(FIRST_LINE.substr(0, FIRST_LINE.size() - 1)));
  file.remove_prefix(FIRST_LINE.size());
  if (file.size() <= CHECKSUM_DIGITS ||
      file.substr(0, CHECKSUM_DIGITS) != checksum(file.substr(CHECKSUM_DIGITS + 1)))
    refuse(path, "it is damaged");
  return file.substr(CHECKSUM_DIGITS + 1);
}

void requireSame(const std::string& path, const Json& saved, const Json& wanted)
{
  for (const auto& [key, value] : wanted.items())
    if (saved.at(key) != value)
      refuse(path, "its " + key + " is " + saved.at(key).dump() + ", but this run's is " + value.dump());
}

}  // namespace

void writeCheckpoint(const std::string& path, const Simulation& simulation, const RunProgress& progress)
{
  Json header = identity(simulation.scene());
  header["time"] = simulation.time();
  header["energy_start"] = progress.energy_start;
  header["through_base"] = progress.through_base;
  const std::string content = header.dump() + '\n' + simulation.saveState();
  AtomicFile file(path);
  file.stream() << FIRST_LINE << checksum(content) << '\n';
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  file.commit();
}

Checkpoint readCheckpoint(const std::string& path, const SceneDefinition& scene)
{
  const std::string file = readAll(path);
  const std::string_view content = checkedContent(path, file);
  const std::size_t end = content.find('\n');
  try
  {
    const Json header = Json::parse(content.substr(0, end));
    requireSame(path, header, identity(scene));
    const RunProgress progress{header.at("energy_start"), header.at("through_base")};
    Checkpoint checkpoint{progress, Simulation(scene, content.substr(end + 1))};
    if (scene.duration < checkpoint.simulation.time())
      refuse(path, "it is at " + header.at("time").dump() + " s, beyond this run's duration");
    return checkpoint;
  }
  catch (const Json::exception& error)
  {
    refuse(path, error.what());
  }
  catch (const StateError& error)
  {
    refuse(path, error.what());
  }
}

}  // namespace ratchet_sieve
