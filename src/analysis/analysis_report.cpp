#include "ratchet_sieve/analysis/analysis_report.h"

#include <algorithm>
#include <optional>

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

std::string ratioText(const std::optional<double>& value)
{
  return value ? fmt::format("{:.3f}", *value) : "undefined";
}

std::string velocityText(const DriftVelocity& velocity)
{
  if (!velocity.mean)
    return "undefined";
  const std::string error =
      velocity.mean_stderr ? fmt::format("{:.2f}", MM_PER_M * *velocity.mean_stderr) : "undefined";
  return fmt::format("{:+.2f} +- {}", MM_PER_M * *velocity.mean, error);
}

std::string temperatureText(const std::optional<double>& temperature)
{
  return temperature ? fmt::format("{:.3g}", UJ_PER_J * *temperature) : "undefined";
}

SpeciesBins binsOf(const RunResult& result, std::size_t species)
{
  return result.lastBins() != nullptr ? result.lastBins()->bins[species] : SpeciesBins{};
}

std::string speciesTable(const RunResult& result)
{
  std::size_t width = 7;
  for (const std::string& name : result.species)
    width = std::max(width, name.size());
  std::string text = fmt::format("{:<{}} {:>7} {:>7} {:>7} {:>8} {:>20} {:>10}\n", "species", width, "disks",
                                 "left", "right", "on base", "<V_x> [mm/s]", "T_g [uJ]");
  for (std::size_t i = 0; i < result.species.size(); ++i)
  {
    const SpeciesBins bins = binsOf(result, i);
    text += fmt::format("{:<{}} {:>7} {:>7} {:>7} {:>8} {:>20} {:>10}\n", result.species[i], width,
                        bins.counted() + bins.on_base, bins.left, bins.right, bins.on_base,
                        velocityText(result.velocities[i]), temperatureText(result.granular_temperatures[i]));
  }
  return text;
}

std::string segregationText(const RunResult& result)
{
  const BinFrame* bins = result.lastBins();
  std::string text =
      fmt::format("Q = {}, P = {}\n", ratioText(bins != nullptr ? bins->quality : std::nullopt),
                  ratioText(bins != nullptr ? bins->processed : std::nullopt));
  if (bins != nullptr && result.species.size() > 2)
    for (const PairQuality& pair : pairQualities(bins->bins))
      text += fmt::format("  Q of {} and {} = {}\n", result.species[pair.first], result.species[pair.second],
                          ratioText(pair.quality));
  return text;
}

std::string contactText(const RunResult& result)
{
  if (result.lastStatistics() == nullptr)
    return "contacts: not recorded\n";
  const CollisionCounts& counts = result.lastStatistics()->collisions;
  return fmt::format(
      "contacts: {} disk-disk, {} left slope, {} right slope, {} apex, {} wall\n"
      "short to long slope: {}\n",
      counts.disk_disk, counts.left_slope, counts.right_slope, counts.apex, counts.wall,
      ratioText(result.shortToLong()));
}

Json speciesJson(const RunResult& result)
{
  Json list = Json::array();
  for (std::size_t i = 0; i < result.species.size(); ++i)
  {
    const SpeciesBins bins = binsOf(result, i);
    list.push_back({{"name", result.species[i]},
                    {"count", bins.counted() + bins.on_base},
                    {"mean_vx", numberOrNull(result.velocities[i].mean)},
                    {"mean_vx_stderr", numberOrNull(result.velocities[i].mean_stderr)},
                    {"left", bins.left},
                    {"right", bins.right},
                    {"on_base", bins.on_base},
                    {"granular_temperature", numberOrNull(result.granular_temperatures[i])}});
  }
  return list;
}

}  // namespace

std::string reportText(const RunResult& result)
{
  return fmt::format("scene {}, seed {}, version {}: {:.6g} s to {:.6g} s, {} frames of particles\n\n",
                     shownText(result.scene_frame.scene_hash), result.scene_frame.seed,
                     shownText(result.scene_frame.version), result.start, result.end,
                     result.particle_frames) +
         speciesTable(result) + "\n" + segregationText(result) + contactText(result);
}

Json reportJson(const RunResult& result)
{
  const BinFrame* bins = result.lastBins();
  Json json;
  json["scene_hash"] = result.scene_frame.scene_hash;
  json["seed"] = result.scene_frame.seed;
  json["version"] = result.scene_frame.version;
  json["start_time"] = result.start;
  json["simulated_time"] = result.end;
  json["particle_frames"] = result.particle_frames;
  json["species"] = speciesJson(result);
  json["quality"] = numberOrNull(bins != nullptr ? bins->quality : std::nullopt);
  json["processed"] = numberOrNull(bins != nullptr ? bins->processed : std::nullopt);
  json["collisions"] = nullptr;
  json["max_overlap"] = nullptr;
  if (const StatisticsFrame* statistics = result.lastStatistics())
  {
    json["collisions"] = collisionCounts(statistics->collisions);
    json["max_overlap"] = statistics->max_overlap;
  }
  json["short_to_long"] = numberOrNull(result.shortToLong());
  return json;
}

}  // namespace ratchet_sieve
