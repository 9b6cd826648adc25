#include "ratchet_sieve/sweep/floor_check.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/recording/estimates.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_run.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* FLOOR_KEY = "contact.min_rebound_speed";

/// Fractions of the scene's minimum rebound speed: two halvings also show the trend of a dependence.
constexpr std::array<double, 2> LOWER_FLOORS = {0.5, 0.25};

constexpr const char* NOT_KNOWN =
    "no error is known, so a dependence on contact.min_rebound_speed cannot be tested";

constexpr double CONFIDENCE = 0.95;  ///< of the intervals over seeds
constexpr int FLOOR_WIDTH = 12;      ///< of a table [characters]
constexpr int RESULT_WIDTH = 26;

std::optional<double> numberIn(const Json& json)
{
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

/// An estimate from the summary's `accuracy`, or the value without an error if there is none.
FloorResult resultOf(const std::string& name, const Json& estimate, const Json& plain)
{
  const std::optional<double> value = numberIn(estimate.at("value"));
  return {name, value ? value : numberIn(plain), numberIn(estimate.at("half_width"))};
}

FloorRun floorRun(double floor, const std::string& error, const Json& summary)
{
  FloorRun run = {floor, error, {}, {}};
  if (summary.is_null())
    return run;
  run.warnings = summary.at("warnings").get<std::vector<std::string>>();
  const Json& accuracy = summary.at("accuracy");
  run.results.push_back(resultOf("quality", accuracy.at("quality"), summary.at("quality")));
  run.results.push_back({"processed", numberIn(summary.at("processed")), std::nullopt});
  for (std::size_t s = 0; s < summary.at("species").size(); ++s)
  {
    const Json& species = summary.at("species")[s];
    run.results.push_back(resultOf("mean_vx." + species.at("name").get<std::string>(),
                                   accuracy.at("mean_vx")[s], species.at("mean_vx")));
  }
  return run;
}

/// The difference of results of independent runs; unknown if either is.
FloorResult difference(const FloorResult& result, const FloorResult& from)
{
  FloorResult moved = {result.name, {}, {}};
  if (result.value && from.value)
    moved.value = *result.value - *from.value;
  if (moved.value && result.half_width && from.half_width)
    moved.half_width = std::hypot(*result.half_width, *from.half_width);
  return moved;
}

std::string resultText(const FloorResult& result, bool with_sign)
{
  if (!result.value)
    return "not defined";
  const std::string text = fmt::format(with_sign ? "{:+.3g}" : "{:.4g}", *result.value);
  return result.half_width ? text + fmt::format(" +- {:.2g}", *result.half_width) : text;
}

/// One line: whether a result depends on the minimum rebound speed. Empty if its error is unknown.
std::string verdict(const FloorResult& moved, double from, double to)
{
  if (!moved.half_width)
    return "";
  const double size = std::abs(*moved.value);
  const std::string text =
      fmt::format("{} changes by {} from {:g} to {:g} m/s: ", moved.name, resultText(moved, true), from, to);
  if (size > *moved.half_width)
    return text + "it depends on " + FLOOR_KEY;
  return text + fmt::format("no significant dependence on {}; a change of up to {:.2g} is not excluded",
                            FLOOR_KEY, size + *moved.half_width);
}

/// Q as a result, with the half-width from the scatter between seeds.
FloorResult qualityOf(const FloorMean& each)
{
  FloorResult result = {"quality", {}, {}};
  if (each.mean)
    result.value = each.mean->quality();
  if (each.mean && each.mean->error)
    result.half_width = *each.mean->error * halfWidthOver(CONFIDENCE, each.mean->seeds);
  return result;
}

Sweep sweepOfFloors(const Sweep& sweep, std::uint64_t point, const std::vector<double>& floors)
{
  Sweep check = sweep;
  for (const Assignment& assignment : sweep.point(point))
    check.fixed.push_back(assignment);
  Axis axis;
  axis.keys = {FLOOR_KEY};
  axis.size = floors.size();
  axis.at = [floors](std::uint64_t k) -> std::vector<Assignment> {
    return {{FLOOR_KEY, fmt::format("{}", floors[k])}};
  };
  axis.text = FLOOR_KEY;
  for (const double floor : floors)
    axis.text += fmt::format(" {}", floor);
  check.axes = {axis};
  return check;
}

}  // namespace

std::optional<std::vector<FloorRun>> runAtLowerFloors(const SceneDefinition& scene, const Json& summary,
                                                      const std::function<bool()>& stop_wanted)
{
  std::vector<FloorRun> runs = {floorRun(scene.contact.min_rebound_speed, "", summary)};
  CaseRunOptions options;
  options.stop_wanted = stop_wanted;
  for (const double part : LOWER_FLOORS)
  {
    SweepCase lower;
    lower.scene = scene;
    lower.scene.contact.min_rebound_speed *= part;
    const std::optional<CaseResult> result = runCase(lower, options);
    if (!result)
      return std::nullopt;
    runs.push_back(floorRun(lower.scene.contact.min_rebound_speed, result->error, result->summary));
  }
  return runs;
}

Json floorCheckJson(const std::vector<FloorRun>& runs)
{
  Json list = Json::array();
  for (const FloorRun& run : runs)
  {
    Json json = {{"min_rebound_speed", run.floor},
                 {"error", run.error.empty() ? Json(nullptr) : Json(run.error)},
                 {"warnings", run.warnings}};
    for (std::size_t k = 0; k < run.results.size(); ++k)
    {
      const FloorResult& result = run.results[k];
      const FloorResult moved = difference(result, runs.front().results[k]);
      json[result.name] = {{"value", numberOrNull(result.value)},
                           {"half_width", numberOrNull(result.half_width)},
                           {"difference", numberOrNull(moved.value)},
                           {"difference_half_width", numberOrNull(moved.half_width)}};
    }
    list.push_back(std::move(json));
  }
  return list;
}

std::vector<std::string> floorCheckLines(const std::vector<FloorRun>& runs)
{
  std::string head = fmt::format("{:<{}}", "floor [m/s]", FLOOR_WIDTH);
  for (const FloorResult& result : runs.front().results)
    head += fmt::format("  {:<{}}", result.name, RESULT_WIDTH);
  std::vector<std::string> lines = {
      "check of contact.min_rebound_speed, one run each, half-widths of intervals:", head};
  for (const FloorRun& run : runs)
  {
    std::string line = fmt::format("{:<{}}", fmt::format("{:g}", run.floor), FLOOR_WIDTH);
    for (const FloorResult& result : run.results)
      line += fmt::format("  {:<{}}", resultText(result, false), RESULT_WIDTH);
    if (!run.warnings.empty())
      line += countText(run.warnings.size(), "warning");
    lines.push_back(line + (run.error.empty() ? "" : "failed: " + run.error));
  }
  const FloorRun& last = runs.back();
  const std::size_t table = lines.size();
  for (std::size_t k = 0; k < last.results.size(); ++k)
  {
    const std::string text =
        verdict(difference(last.results[k], runs.front().results[k]), runs.front().floor, last.floor);
    if (!text.empty())
      lines.push_back(text);
  }
  if (lines.size() == table)
    lines.push_back(NOT_KNOWN);
  return lines;
}

std::optional<std::vector<FloorMean>> runSettingAtLowerFloors(const Sweep& sweep, std::uint64_t point,
                                                              const std::string& results,
                                                              const SweepRunOptions& options)
{
  const double own = CaseBuilder(sweep).at(point * sweep.seedCount()).scene.contact.min_rebound_speed;
  std::vector<double> floors = {own};
  for (const double part : LOWER_FLOORS)
    floors.push_back(part * own);
  const Sweep check = sweepOfFloors(sweep, point, floors);
  if (runSweep(check, results, options).stopped)
    return std::nullopt;
  ResultStore store(results, Database::Access::READ);
  const SweepPlan plan = SweepPlan::findOrWorkOut(store.database(), check);
  std::vector<FloorMean> means;
  for (std::size_t k = 0; k < floors.size(); ++k)
    means.push_back({floors[k], meanOfSetting(store, plan, check, k)});
  return means;
}

Json floorCheckJson(const std::vector<FloorMean>& means)
{
  Json list = Json::array();
  for (const FloorMean& each : means)
    list.push_back({{"min_rebound_speed", each.floor},
                    {"quality", each.mean ? Json(each.mean->quality()) : Json(nullptr)},
                    {"quality_stderr", each.mean ? numberOrNull(each.mean->error) : Json(nullptr)},
                    {"seeds", each.mean ? each.mean->seeds : 0}});
  return list;
}

std::vector<std::string> floorCheckLines(const std::vector<FloorMean>& means)
{
  std::vector<std::string> lines;
  lines.reserve(means.size() + 1);
  for (const FloorMean& each : means)
    lines.push_back(fmt::format("best setting at {} = {:g} m/s: {}", FLOOR_KEY, each.floor,
                                each.mean ? "Q " + meanText(*each.mean) : "Q not defined"));
  const std::string text = verdict(difference(qualityOf(means.back()), qualityOf(means.front())),
                                   means.front().floor, means.back().floor);
  lines.push_back(text.empty() ? NOT_KNOWN : text + " (half-width of 95 %)");
  return lines;
}

}  // namespace ratchet_sieve
