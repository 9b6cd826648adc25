#include "ratchet_sieve/page/run_page.h"

#include <algorithm>
#include <optional>

#include "deflate.h"
#include "html_page.h"
#include "motion_record.h"
#include "page_parts.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// Commands that a page lists: the first. A node that follows a controller may get thousands a second.
constexpr std::size_t MOST_COMMANDS = 1000;

/// What a page holds beside its template, its data and their base64: names of elements, the description of
/// the motion [bytes].
constexpr std::size_t AROUND_DATA = 2000;

std::size_t inBase64(std::size_t bytes)
{
  return (bytes + 2) / 3 * 4;
}

}  // namespace

struct RunPage::Implementation
{
  explicit Implementation(std::size_t page_size) : size(page_size) {}

  void begin(const SceneFrame& frame);

  std::size_t size;
  RunAnalysis analysis;
  std::optional<Scene> scene;
  std::optional<MotionRecord> motion;
  std::vector<CommandFrame> commands;
  std::size_t commands_taken = 0;
};

void RunPage::Implementation::begin(const SceneFrame& frame)
{
  motion.reset();  // before the scene, to which it refers
  scene = sceneFromText(frame.yaml, "recorded scene");
  motion.emplace(scene->definition, size);
  commands.clear();
  commands_taken = 0;
}

RunPage::RunPage(std::size_t size) : implementation_(std::make_unique<Implementation>(size)) {}

RunPage::~RunPage() = default;

void RunPage::take(const AnyFrame& any)
{
  Implementation& page = *implementation_;
  page.analysis.take(any);  // checks the frame
  if (const auto* scene = any.as<SceneFrame>())
    page.begin(*scene);
  else if (const auto* particles = any.as<ParticleFrame>())
    page.motion->take(*particles);
  else if (const auto* command = any.as<CommandFrame>())
    if (page.commands_taken++ < MOST_COMMANDS)
      page.commands.push_back(*command);
}

const RunAnalysis& RunPage::analysis() const
{
  return implementation_->analysis;
}

void RunPage::write(const std::string& path, const std::string& title,
                    const std::vector<std::string>& warnings) const
{
  const Implementation& page = *implementation_;
  const RunResult result = page.analysis.result();
  const SceneDefinition& scene = page.scene->definition;
  nlohmann::ordered_json json;
  json["title"] = title;
  json["scene"] = {{"yaml", result.scene_frame.yaml},
                   {"hash", result.scene_frame.scene_hash},
                   {"seed", result.scene_frame.seed},
                   {"version", result.scene_frame.version}};
  json["plan"] = planText(planOf(scene));
  std::vector<std::string> all_warnings = warnings;
  for (const std::string& warning : page.scene->warnings)
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      all_warnings.push_back(warning);
  json["warnings"] = all_warnings;
  json["results"] = reportJson(result);
  json["machine"] = machinePart(scene);
  json["commands"] = commandsPart(page.commands, scene);
  json["commands_taken"] = page.commands_taken;

  const std::string series = deflated(jsonForHtml(seriesPart(result)));
  const std::size_t rest =
      AROUND_DATA + lengthOf(RUN_TEMPLATE) + jsonForHtml(json).size() + inBase64(series.size());
  const std::size_t for_motion = page.size > rest ? (page.size - rest) / 4 * 3 : 0;
  EncodedMotion motion = page.motion->encoded(for_motion);
  json["motion"] = std::move(motion.description);
  writePage(path, RUN_TEMPLATE, title, json, {{"series", series}, {"motion", std::move(motion.bytes)}});
}

FrameRates pageRates(double rate)
{
  FrameRates rates;
  rates.particles = rates.base = rate;
  return rates;
}

}  // namespace ratchet_sieve
