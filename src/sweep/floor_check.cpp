#include "ratchet_sieve/sweep/floor_check.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "ratchet_sieve/recording/estimates.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/case.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* FLOOR_KEY = "contact.min_rebound_speed";

/// Fractions of the scene's minimum rebound speed: two halvings also show the trend of a dependence.
constexpr std::array<double, 2> LOWER_FLOORS = {0.5, 0.25};

constexpr int FLOOR_WIDTH = 12;  ///< of a table [characters]
constexpr int RESULT_WIDTH = 26;

/// An estimate from the summary's `accuracy`, or the value without an error if there is none.
Json resultOf(const Json& estimate, const Json& plain)
{
  const Json& value = estimate.at("value");
  return {{"value", value.is_null() ? plain : value}, {"half_width", estimate.at("half_width")}};
}

/// The results of a run, by their names.
Json resultsOf(const Json& summary)
{
  Json results = Json::object();
  if (summary.is_null())
    return results;
  const Json& accuracy = summary.at("accuracy");
  results["quality"] = resultOf(accuracy.at("quality"), summary.at("quality"));
  results["processed"] = {{"value", summary.at("processed")}, {"half_width", nullptr}};
  for (std::size_t s = 0; s < summary.at("species").size(); ++s)
  {
    const Json& species = summary.at("species")[s];
    results["mean_vx." + species.at("name").get<std::string>()] =
        resultOf(accuracy.at("mean_vx")[s], species.at("mean_vx"));
  }
  return results;
}

/// @param own results at the scene's own floor
Json floorRun(double floor, const std::string& error, const Json& summary, const Json& own)
{
  Json run = {{"min_rebound_speed", floor},
              {"error", error.empty() ? Json(nullptr) : Json(error)},
              {"warnings", summary.is_null() ? Json::array() : summary.at("warnings")}};
  const Json results = resultsOf(summary);
  for (const auto& [name, result] : results.items())
  {
    const Json& from = own.at(name);
    const auto combined = [&, &result = result](const char* field, double (*combine)(double, double)) -> Json
    {
      if (result[field].is_null() || from[field].is_null())
        return nullptr;
      return combine(result[field].get<double>(), from[field].get<double>());
    };
    const Json moved = combined("value", [](double a, double b) { return a - b; });
    const Json width = combined("half_width", [](double a, double b) { return std::hypot(a, b); });
    run[name] = result;
    run[name]["difference"] = moved;
    run[name]["difference_half_width"] = moved.is_null() ? Json(nullptr) : width;
  }
  return run;
}

std::string resultText(const Json& value, const Json& half_width, bool with_sign)
{
  if (value.is_null())
    return "not defined";
  const std::string text = fmt::format(with_sign ? "{:+.3g}" : "{:.4g}", value.get<double>());
  return half_width.is_null() ? text : text + fmt::format(" ± {:.2g}", half_width.get<double>());
}

/// Whether a result of the last run depends on the floor; its error is known.
std::string verdict(const std::string& name, const Json& result, double from, double to)
{
  const Json& moved = result["difference"];
  const Json& width = result["difference_half_width"];
  const double size = std::abs(moved.get<double>());
  const std::string text =
      fmt::format("{} changes by {} from {:g} to {:g} m/s: ", name, resultText(moved, width, true), from, to);
  if (size > width.get<double>())
    return text + "it depends on " + FLOOR_KEY;
  return text + fmt::format("no significant dependence on {}; a change of up to {:.2g} is not excluded",
                            FLOOR_KEY, size + width.get<double>());
}

}  // namespace

Json floorCheck(const SceneDefinition& scene, const Json& summary, const std::function<bool()>& stop_wanted)
{
  const Json own = resultsOf(summary);
  Json runs = Json::array({floorRun(scene.contact.min_rebound_speed, "", summary, own)});
  CaseRunOptions options;
  options.stop_wanted = stop_wanted;
  for (const double part : LOWER_FLOORS)
  {
    SweepCase lower;
    lower.scene = scene;
    lower.scene.contact.min_rebound_speed *= part;
    const std::optional<CaseResult> result = runCase(lower, options);
    if (!result)
      return nullptr;
    runs.push_back(floorRun(lower.scene.contact.min_rebound_speed, result->error, result->summary, own));
  }
  return runs;
}

std::vector<std::string> floorCheckLines(const Json& runs)
{
  std::vector<std::string> lines = {
      "check of contact.min_rebound_speed, one run each, half-widths of intervals:",
      fmt::format("{:<{}}", "floor [m/s]", FLOOR_WIDTH)};
  for (const auto& [name, result] : runs.front().items())
    if (result.is_object())
      lines.back() += fmt::format("  {:<{}}", name, RESULT_WIDTH);
  const auto floor_of = [](const Json& run) { return run["min_rebound_speed"].get<double>(); };
  std::vector<std::string> verdicts;
  for (const Json& run : runs)
  {
    std::string line = fmt::format("{:<{}}", fmt::format("{:g}", floor_of(run)), FLOOR_WIDTH);
    for (const auto& [name, result] : run.items())
    {
      if (!result.is_object())
        continue;
      line += fmt::format("  {:<{}}", resultText(result["value"], result["half_width"], false), RESULT_WIDTH);
      if (&run == &runs.back() && !result["difference_half_width"].is_null())
        verdicts.push_back(verdict(name, result, floor_of(runs.front()), floor_of(run)));
    }
    if (!run["warnings"].empty())
      line += countText(run["warnings"].size(), "warning");
    lines.push_back(line + (run["error"].is_null() ? "" : "failed: " + run["error"].get<std::string>()));
  }
  if (verdicts.empty())
    verdicts = {"no error is known, so a dependence on contact.min_rebound_speed cannot be tested"};
  lines.insert(lines.end(), verdicts.begin(), verdicts.end());
  return lines;
}

}  // namespace ratchet_sieve
