#include "ratchet_sieve/page/run_page.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "html_page.h"
#include "motion.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/recording/json.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/scene_text.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

/// Commands that a page lists: the first. A node that follows a controller may get thousands a second.
constexpr std::size_t MOST_COMMANDS = 1000;

/// What a page holds beside its template, its data and their base64: names of elements, the description of
/// the motion [bytes].
constexpr std::size_t AROUND_DATA = 2000;

/// Rows of the bins that a page has at most.
constexpr std::size_t MOST_ROWS = 4096;

/// Whether the commanded quantities are the same.
bool isSame(const DriveState& a, const DriveState& b)
{
  return std::all_of(COMMANDED_QUANTITIES.begin(), COMMANDED_QUANTITIES.end(),
                     [&](const CommandedQuantity& each) {
                       return a.*each.applied == b.*each.applied && a.*each.commanded == b.*each.commanded;
                     });
}

/// The recorded states of the base where it changes, or those that follow from the scene if none was
/// recorded.
std::vector<BaseFrame> baseFrames(const RunResult& result)
{
  const std::vector<BaseFrame>& all = result.base;
  if (all.empty())
    return {{result.start, driveStateAt(result.scene.base, 0.0)},
            {result.end, driveStateAt(result.scene.base, result.end - result.start)}};
  std::vector<BaseFrame> frames;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k == 0 || k + 1 == all.size() || !isSame(all[k - 1].base, all[k].base) ||
        !isSame(all[k].base, all[k + 1].base))
      frames.push_back(all[k]);
  return frames;
}

/// Adds values of a row to the columns of their names.
void addRow(Json& columns, const Json& row, std::initializer_list<const char*> names)
{
  for (const char* name : names)
    columns[name].push_back(row.at(name));
}

Json driveSeries(const RunResult& result)
{
  Json series;
  for (const BaseFrame& frame : baseFrames(result))
  {
    series["time"].push_back(frame.time);
    addRow(series, frame.base,
           {"phase", "inclination", "frequency", "amplitude", "commanded_inclination", "commanded_frequency",
            "commanded_amplitude"});
  }
  return series;
}

Json binSeries(const RunResult& result)
{
  Json series = {{"time", Json::array()}, {"species", Json::array()}};
  if (result.bins.empty())
    return series;
  const std::size_t last = result.bins.size() - 1;
  const std::size_t every = last / MOST_ROWS + 1;
  for (std::size_t k = 0; k <= last; ++k)
  {
    if (k % every != 0 && k != last)
      continue;
    const BinFrame& frame = result.bins[k];
    addRow(series, frame, {"time", "quality", "processed", "separation"});
    for (std::size_t i = 0; i < frame.bins.size(); ++i)
      addRow(series["species"][i], frame.bins[i], {"left", "right", "on_base"});
  }
  return series;
}

/// <V_x> of each species since the end of `settle`, as the engine accumulates it.
Json velocitySeries(const RunResult& result)
{
  Json series = {{"time", Json::array()}, {"species", Json::array()}};
  for (const StatisticsFrame& frame : result.statistics)
  {
    series["time"].push_back(frame.time);
    for (std::size_t i = 0; i < frame.species.size(); ++i)
      addRow(series["species"][i], frame.species[i].means, {"mean_vx", "mean_vx_stderr"});
  }
  return series;
}

std::string commandText(const CommandFrame& command, const SceneDefinition& scene)
{
  if (const auto quantity = setpointQuantity(command.kind))
    return fmt::format("{} {:.6g} {}", describe(*quantity).name,
                       command.values.empty() ? 0.0 : command.values.front(), describe(*quantity).unit);
  switch (command.kind)
  {
    case CommandKind::SLEW_RATES:
    {
      std::string text = "slew rates:";
      for (std::size_t k = 0; k < command.values.size() && k < QUANTITIES; ++k)
        text += fmt::format("{} {} {:.6g} {}/s", k > 0 ? "," : "", COMMANDED_QUANTITIES[k].name,
                            command.values[k], COMMANDED_QUANTITIES[k].unit);
      return text;
    }
    case CommandKind::POUR:
    {
      const auto between = pouredBetween(command);
      return fmt::format(
          "pour {} of {}{}", countText(command.count, "disk"),
          command.species < scene.species.size() ? scene.species[command.species].name : "an unknown species",
          between ? fmt::format(" between {:.6g} and {:.6g} m", between->from, between->to) : "");
    }
    case CommandKind::PAUSE:
      return "pause";
    case CommandKind::UNPAUSE:
      return "unpause";
    default:
      return "unknown command";
  }
}

/// The unit of each number and column of what was observed, by the observable's name.
Json unitsOf(const std::vector<Observed>& all)
{
  Json units = Json::object();
  for (const Observed& observed : all)
    for (const ObservedRow& row : observed.rows)
    {
      for (const ObservedNumber& number : row.numbers)
        units[observed.name][number.name] = number.unit;
      for (const ObservedColumn& column : row.table)
        units[observed.name][column.name] = column.unit;
    }
  return units;
}

}  // namespace

void RunPage::begin(const SceneFrame& frame)
{
  scene_ = sceneFromText(frame.yaml, "recorded scene");
  motion_ = std::make_unique<MotionRecord>(scene_.definition, size_);
  commands_.clear();
  commands_taken_ = 0;
}

RunPage::RunPage(std::size_t size) : size_(size) {}

RunPage::~RunPage() = default;

void RunPage::take(const AnyFrame& any)
{
  analysis_.take(any);  // checks the frame
  if (const auto* scene = any.as<SceneFrame>())
    begin(*scene);
  else if (const auto* particles = any.as<ParticleFrame>())
    motion_->add(*particles);
  else if (const auto* command = any.as<CommandFrame>())
    if (commands_taken_++ < MOST_COMMANDS)
      commands_.push_back(*command);
}

void RunPage::write(AtomicFile&& file, const std::string& title, const Json& summary) const
{
  const RunResult result = analysis_.result();
  const SceneDefinition& scene = scene_.definition;
  Json json;
  json["title"] = title;
  json["scene"] = {{"yaml", result.scene_frame.yaml},
                   {"hash", result.scene_frame.scene_hash},
                   {"seed", result.scene_frame.seed},
                   {"version", result.scene_frame.version}};
  json["plan"] = planText(planOf(scene));
  json["warnings"] = summary.value("warnings", Json::array());
  for (const std::string& warning : scene_.warnings)
    if (std::find(json["warnings"].begin(), json["warnings"].end(), warning) == json["warnings"].end())
      json["warnings"].push_back(warning);
  json["results"] = reportJson(result);
  json["units"] = unitsOf(result.observed);
  for (const char* key : {"steady", "steady_reason"})
    if (summary.contains(key))
      json["results"][key] = summary.at(key);
  json["machine"] = machinePart(scene);
  json["commands"] = Json::array();
  for (const CommandFrame& command : commands_)
    json["commands"].push_back({{"time", command.time}, {"text", commandText(command, scene)}});
  json["commands_taken"] = commands_taken_;

  const std::string series = deflated(jsonForHtml(
      {{"drive", driveSeries(result)}, {"bins", binSeries(result)}, {"velocities", velocitySeries(result)}}));
  const std::size_t rest =
      AROUND_DATA + RUN_TEMPLATE.size() + jsonForHtml(json).size() + base64(series).size();
  const std::size_t for_motion = size_ > rest ? (size_ - rest) / 4 * 3 : 0;
  EncodedMotion motion = motion_->encoded(for_motion);
  json["motion"] = std::move(motion.description);
  writePage(std::move(file), RUN_TEMPLATE, title, json,
            {{"series", series}, {"motion", std::move(motion.bytes)}});
}

FrameRates pageRates(double rate)
{
  FrameRates rates;
  rates.particles = rates.base = rate;
  return rates;
}

}  // namespace ratchet_sieve
