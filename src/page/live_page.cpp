#include "ratchet_sieve/page/live_page.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "html_page.h"
#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/state_archive.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

/// The largest seed that JavaScript tells from the next.
constexpr std::uint64_t LARGEST_SEED = (1ULL << 53) - 1;

/// What the sliders of the commanded quantities need: a node's limits, wider where the scene is beyond them.
Json quantitiesOf(const SceneDefinition& scene)
{
  const SlewRates rates;
  Json quantities = Json::array();
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
  {
    const double value = scene.base.*quantity.definition;
    quantities.push_back({{"name", quantity.name},
                          {"unit", quantity.unit},
                          {"min", std::min(quantity.usual.min, value)},
                          {"max", std::max(quantity.usual.max, value)},
                          {"value", value},
                          {"slew_rate", rates.*quantity.slew_rate},
                          {"slowest", quantity.slew_rates.min},
                          {"fastest", quantity.slew_rates.max}});
  }
  return quantities;
}

Json sceneOf(const OfferedScene& offered)
{
  const SceneDefinition& scene = offered.scene.definition;
  StateArchive archive;
  SceneDefinition(scene).archive(archive);
  return {{"name", offered.name},
          {"title", offered.title},
          {"sentence", offered.sentence},
          {"yaml", canonicalYaml(scene)},
          {"warnings", offered.scene.warnings},
          {"definition", base64(archive.takeBytes())},
          {"seed", std::min(scene.seed, LARGEST_SEED)},
          {"feed_rate", scene.feed.rate},
          {"quantities", quantitiesOf(scene)},
          {"machine", machinePart(scene)}};
}

}  // namespace

void writeLivePage(const std::string& path, const std::vector<OfferedScene>& scenes,
                   const std::string& engine)
{
  Json offered = Json::array();
  for (const OfferedScene& each : scenes)
    offered.push_back(sceneOf(each));
  writePage(path, LIVE_TEMPLATE, "Ratchet sieve, live",
            {{"version", version()}, {"scenes", std::move(offered)}}, {{"engine", deflated(engine)}});
}

}  // namespace ratchet_sieve
