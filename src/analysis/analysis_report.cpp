#include "ratchet_sieve/analysis/analysis_report.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr double MM_PER_M = 1e3;
constexpr double UJ_PER_J = 1e6;
constexpr double MS_PER_S = 1e3;

/// A number of the report, times `scale`.
std::string numberText(const Json& number, const char* format, double scale = 1.0)
{
  return number.is_null() ? "undefined" : fmt::format(fmt::runtime(format), scale * number.get<double>());
}

std::string ratioText(const Json& ratio)
{
  return numberText(ratio, "{:.3f}");
}

/// @param by "engine_" for the one that the engine accumulated, "" for the one of the frames
std::string velocityText(const Json& species, const std::string& by)
{
  const Json& mean = species[by + "mean_vx"];
  return numberText(mean, "{:+.2f}", MM_PER_M) +
         (mean.is_null() ? "" : " ± " + numberText(species[by + "mean_vx_stderr"], "{:.2f}", MM_PER_M));
}

/// A note whether the run is exact, or may have missed contacts.
std::string methodText(const SceneDefinition& scene)
{
  return planOf(scene).steps ? fmt::format(" by steps of {:g} ms", MS_PER_S * scene.accuracy.step) : "";
}

/// The means accumulated by the engine; undefined if they were not recorded.
SpeciesMeans engineMeans(const RunResult& result, std::size_t species)
{
  return result.lastStatistics() != nullptr ? result.lastStatistics()->species[species].means
                                            : SpeciesMeans();
}

/// The means accumulated by the engine, if they were recorded. They include the last part of the path of a
/// disk that leaves, which frames lack.
std::string engineText(const RunResult& result)
{
  if (result.lastStatistics() == nullptr)
    return "";
  std::string text = "accumulated by the engine:\n";
  for (std::size_t i = 0; i < result.species.size(); ++i)
  {
    std::string values;
    const auto add = [&values](const FieldInfo& field, const std::optional<double>& mean)
    {
      values += fmt::format("{} {} {}", values.empty() ? "" : ",", field.name,
                            mean ? fmt::format("{:.4g} {}", *mean, field.unit) : "undefined");
    };
    const SpeciesMeans means = engineMeans(result, i);
    Fields<SpeciesMeans>::each(add, means);
    text += fmt::format("  {}:{}\n", result.species[i], values);
  }
  return text;
}

/// The kinds of frames that are missing, and the results that need them.
std::string missingText(const RunResult& result)
{
  const std::map<std::string, std::string> means = {
      {"particles", "no <V_x>, no displacements"},
      {"bins", "no counts, no Q, no P"},
      {"base", "no inclination, frequency and amplitude over time"},
      {"statistics", "no temperatures, no contacts"},
      {"observed", "nothing of what the scene observes, no size classes"}};
  std::string text;
  for (const std::string& kind : result.missing())
    text += fmt::format("not recorded: {} ({})\n", kind, means.at(kind));
  return text;
}

/// Whether disks can leave, or have left over the walls. Bins are reported only then.
bool isOpen(const RunResult& result)
{
  const auto something_left = [](const SpeciesBins& bins) { return bins.left + bins.right > 0; };
  return result.scene.boundary == Boundary::OPEN ||
         (!result.bins.empty() &&
          std::any_of(result.bins.back().bins.begin(), result.bins.back().bins.end(), something_left));
}

/// What is of the frames alone, and of which.
std::string framesText(const RunResult& result, const Json& all)
{
  std::string text;
  if (result.first_frame && *result.first_frame > result.start)
    text += fmt::format(
        "recorded from {:.6g} s on: T_g and <V_x> of the frames are of this part, all else is of "
        "the whole run\n",
        *result.first_frame);
  if (result.lastStatistics() == nullptr || result.particle_frames == 0)
    return text;
  text += "<V_x> of the frames, without each disk's way before its first and after its last one:\n";
  for (const Json& species : all)
    text += fmt::format("  {}: {} mm/s\n", species["name"].get<std::string>(), velocityText(species, ""));
  return text;
}

std::string speciesTable(const RunResult& result, const Json& all)
{
  std::size_t width = 7;
  for (const std::string& name : result.species)
    width = std::max(width, name.size());
  const auto row = [&](const std::string& name, const std::array<std::string, 4>& counts,
                       const std::string& velocity, const std::string& temperature)
  {
    const auto& [disks, left, right, on_base] = counts;
    const std::string bins = isOpen(result) ? fmt::format(" {:>7} {:>7} {:>8}", left, right, on_base) : "";
    return fmt::format("{:<{}} {:>7}{} {:>20} {:>10}\n", name, width, disks, bins, velocity, temperature);
  };
  const auto count = [](const Json& number) { return number.is_null() ? "-" : number.dump(); };
  std::string text = row("species", {"disks", "left", "right", "on base"}, "<V_x> [mm/s]", "T_g [uJ]");
  for (const Json& species : all)
    text += row(
        species["name"],
        {count(species["count"]), count(species["left"]), count(species["right"]), count(species["on_base"])},
        velocityText(species, result.lastStatistics() != nullptr ? "engine_" : ""),
        numberText(species["granular_temperature"], "{:.3g}", UJ_PER_J));
  return text + framesText(result, all);
}

std::string segregationText(const RunResult& result)
{
  if (!isOpen(result))
    return "no disk can leave this base: no bins, no Q, no P\n";
  const BinFrame* bins = result.lastBins();
  if (bins == nullptr)
    return "s, Q and P: undefined\n";
  std::string text = fmt::format("s = {}, Q = {}, P = {}\n", ratioText(bins->separation),
                                 ratioText(bins->quality), ratioText(bins->processed));
  if (result.species.size() > 2)
    for (const PairSeparation& pair : pairSeparations(bins->bins))
      text += fmt::format("  s of {} and {} = {}\n", result.species[pair.first], result.species[pair.second],
                          ratioText(pair.separation));
  return text;
}

std::string contactText(const RunResult& result)
{
  if (result.lastStatistics() == nullptr)
    return "contacts: undefined\n";
  const CollisionCounts& counts = result.lastStatistics()->collisions;
  return fmt::format(
      "contacts: {} disk-disk, {} left slope, {} right slope, {} apex, {} wall, {} level\n"
      "short to long slope: {}\n",
      counts.disk_disk, counts.left_slope, counts.right_slope, counts.apex, counts.wall, counts.level,
      ratioText(result.shortToLong()));
}

Json speciesJson(const RunResult& result)
{
  Json list = Json::array();
  for (std::size_t i = 0; i < result.species.size(); ++i)
  {
    std::optional<SpeciesBins> bins;  // nothing if they were not recorded
    if (result.lastBins() != nullptr)
      bins = result.lastBins()->bins[i];
    const auto count = [&bins](std::uint64_t number) { return bins ? Json(number) : Json(nullptr); };
    const SpeciesBins counts = bins.value_or(SpeciesBins());
    Json json = {{"name", result.species[i]},
                 {"count", count(counts.counted() + counts.on_base)},
                 {"mean_vx", result.velocities[i].mean},
                 {"mean_vx_stderr", result.velocities[i].mean_stderr},
                 {"engine_mean_vx", engineMeans(result, i).mean_vx},
                 {"engine_mean_vx_stderr", engineMeans(result, i).mean_vx_stderr},
                 {"left", count(counts.left)},
                 {"right", count(counts.right)},
                 {"on_base", count(counts.on_base)},
                 {"granular_temperature", result.granular_temperatures[i]}};
    addMeans(json, engineMeans(result, i));
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

std::string reportText(const RunResult& result)
{
  return fmt::format("scene {}, seed {}, version {}: {:.6g} s to {:.6g} s{}, {} of particles\n\n",
                     shownText(result.scene_frame.scene_hash), result.scene_frame.seed,
                     shownText(result.scene_frame.version), result.start, result.end,
                     methodText(result.scene), countText(result.particle_frames, "frame")) +
         speciesTable(result, speciesJson(result)) + "\n" + segregationText(result) + contactText(result) +
         engineText(result) + missingText(result);
}

Json reportJson(const RunResult& result)
{
  Json json;
  json["scene_hash"] = result.scene_frame.scene_hash;
  json["seed"] = result.scene_frame.seed;
  json["version"] = result.scene_frame.version;
  json["plan"] = planParts(planOf(result.scene));
  json["start_time"] = result.start;
  json["first_frame_time"] = result.first_frame;
  json["simulated_time"] = result.end;
  json["particle_frames"] = result.particle_frames;
  json["not_recorded"] = result.missing();
  json["species"] = speciesJson(result);
  addBinResults(json, result.species,
                result.lastBins() != nullptr ? result.lastBins()->bins
                                             : std::vector<SpeciesBins>(result.species.size()));
  for (const char* contacts : {"collisions", "max_overlap", "short_to_long"})
    json[contacts] = nullptr;
  if (const StatisticsFrame* statistics = result.lastStatistics())
  {
    addContacts(json, result.scene, statistics->collisions, statistics->faces);
    json["max_overlap"] = statistics->max_overlap;
  }
  addObserved(json, result.observed);
  return json;
}

}  // namespace ratchet_sieve
