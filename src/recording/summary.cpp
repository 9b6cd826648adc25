#include "ratchet_sieve/recording/summary.h"

#include <cmath>

#include "ratchet_sieve/core/segregation.h"
#include "ratchet_sieve/recording/certainty.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

/// Adds the results by size class for a species that has sizes.
void addSizeClasses(Json& species, std::size_t index, const Simulation& simulation)
{
  const std::vector<SizeClass>& classes = simulation.sizeClasses();
  const std::vector<SpeciesMeans> means = simulation.sizeClassMeans();
  std::vector<SpeciesBins> bins;
  Json list = Json::array();
  for (std::size_t k = 0; k < classes.size(); ++k)
  {
    if (classes[k].species != index)
      continue;
    bins.push_back(simulation.sizeClassBins()[k]);
    list.push_back({{"radius", {classes[k].smallest, classes[k].largest}},
                    {"count", bins.back().counted() + bins.back().on_base},
                    {"left", bins.back().left},
                    {"right", bins.back().right},
                    {"mean_vx", numberOrNull(means[k].mean_vx)},
                    {"mean_vx_stderr", numberOrNull(means[k].mean_vx_stderr)}});
  }
  if (list.empty())
    return;
  species["size_quality"] = numberOrNull(bestSeparation(bins).quality());
  species["size_classes"] = std::move(list);
}

Json speciesResults(const Simulation& simulation)
{
  const std::vector<SpeciesBins> bins = simulation.bins();
  const std::vector<SpeciesMeans> means = simulation.means();
  Json list = Json::array();
  for (std::size_t i = 0; i < bins.size(); ++i)
  {
    Json json;
    json["name"] = simulation.scene().species[i].name;
    json["count"] = bins[i].counted() + bins[i].on_base;
    json["left"] = bins[i].left;
    json["right"] = bins[i].right;
    addMeans(json, means[i]);
    addSizeClasses(json, i, simulation);
    list.push_back(std::move(json));
  }
  return list;
}

Json pairResults(const Simulation& simulation)
{
  Json list = Json::array();
  for (const PairSeparation& pair : pairSeparations(simulation.bins()))
  {
    const auto& species = simulation.scene().species;
    list.push_back({{"species", {species[pair.first].name, species[pair.second].name}},
                    {"quality", numberOrNull(pair.quality())},
                    {"separation", numberOrNull(pair.separation)},
                    {"separation_by_mass", numberOrNull(pair.by_mass)}});
  }
  return list;
}

Json estimateOrNull(const std::optional<Estimate>& estimate)
{
  return {{"value", estimate ? Json(estimate->value) : Json(nullptr)},
          {"half_width", estimate ? Json(estimate->half_width) : Json(nullptr)}};
}

Json certaintyParts(const Simulation& simulation)
{
  const Certainty certainty = certaintyOf(simulation);
  const SceneDefinition& scene = simulation.scene();
  Json json;
  json["reached"] = certainty.reached() ? Json(*certainty.reached()) : Json(nullptr);
  json["confidence"] = scene.accuracy.confidence;
  json["transient"] = numberOrNull(certainty.means.transient);
  json["mean_vx"] = Json::array();
  for (std::size_t s = 0; s < scene.species.size(); ++s)
  {
    const std::optional<SteadyMean>& mean = certainty.means.of[s];
    Json species = {{"name", scene.species[s].name}};
    species.update(estimateOrNull(mean ? std::optional(mean->estimate) : std::nullopt));
    json["mean_vx"].push_back(std::move(species));
  }
  std::optional<Estimate> estimate;
  if (certainty.separation)
    estimate = certainty.separation->estimate;
  json["separation"] = estimateOrNull(estimate);
  if (estimate)
    estimate->value = std::abs(estimate->value);
  json["quality"] = estimateOrNull(estimate);
  return json;
}

}  // namespace

Json observedResults(const Observed& observed)
{
  Json json;
  for (const ObservedRow& row : observed.rows)
  {
    Json of_row = {{"name", row.species}};
    for (const ObservedNumber& number : row.numbers)
      of_row[number.name] = numberOrNull(number.value);
    for (const ObservedColumn& column : row.table)
    {
      Json& values = of_row["table"][column.name] = Json::array();
      for (const std::optional<double>& value : column.values)
        values.push_back(numberOrNull(value));
    }
    (row.place.empty() ? json : json[row.place]).push_back(std::move(of_row));
  }
  return json;
}

Json planParts(const Plan& plan)
{
  return {{"pairs", plan.pairs},
          {"steps", plan.steps},
          {"spin", plan.spin},
          {"drive", plan.drive},
          {"orbit", plan.orbit},
          {"contact_times", plan.contact_times},
          {"search_above_band", plan.search_above_band},
          {"simd", plan.simd}};
}

void addSeparation(Json& json, const std::vector<SpeciesBins>& bins)
{
  const PairSeparation best = bestSeparation(bins);
  json["quality"] = numberOrNull(best.quality());
  json["separation"] = numberOrNull(best.separation);
  json["separation_by_mass"] = numberOrNull(best.by_mass);
}

void addBinShares(Json& json, const std::vector<std::string>& species, const std::vector<SpeciesBins>& bins)
{
  const std::vector<SpeciesShares> shares = binShares(bins);
  for (const auto& [key, share] :
       {std::pair{"purity", &BinShare::purity}, std::pair{"recovery", &BinShare::recovery}})
    for (const auto& [bin, of_bin] :
         {std::pair{"left", &SpeciesShares::left}, std::pair{"right", &SpeciesShares::right}})
    {
      Json& list = json[key][bin] = Json::array();
      for (std::size_t s = 0; s < shares.size(); ++s)
      {
        const BinShares& in_bin = shares[s].*of_bin;
        list.push_back({{"name", species[s]},
                        {"number", numberOrNull(in_bin.number.*share)},
                        {"mass", numberOrNull(in_bin.mass.*share)}});
      }
    }
}

Json collisionCounts(const CollisionCounts& counts)
{
  Json json;
  Fields<CollisionCounts>::each(
      [&json](const FieldInfo& field, std::uint64_t count) { json[field.name] = count; }, counts);
  return json;
}

Json contactsByFace(const FaceContacts& contacts)
{
  return {{"faces", contacts.face_contacts}, {"corners", contacts.corner_contacts}};
}

Json numberOrNull(const std::optional<double>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

void addMeans(Json& species, const SpeciesMeans& means)
{
  Fields<SpeciesMeans>::each([&species](const FieldInfo& field, const std::optional<double>& mean)
                             { species.emplace(field.name, numberOrNull(mean)); },
                             means);
}

Json summarize(const Simulation& simulation, const RunOutcome& outcome)
{
  const SceneDefinition& scene = simulation.scene();
  Json json;
  json["scene_hash"] = sceneHash(scene);
  json["seed"] = scene.seed;
  json["version"] = version();
  json["plan"] = planParts(simulation.plan());
  json["simulated_time"] = simulation.time();
  json["wall_time"] = outcome.wall_time;
  json["events"] = simulation.events();
  json["collisions"] = collisionCounts(simulation.collisions());
  json["short_to_long"] = numberOrNull(simulation.collisions().shortToLong(scene.base.slopeAsymmetry()));
  if (!scene.base.isSawtooth())
    json["contacts_by_face"] = contactsByFace(simulation.faceContacts());
  json["species"] = speciesResults(simulation);
  addSeparation(json, simulation.bins());
  if (scene.species.size() > 2)
    json["pair_qualities"] = pairResults(simulation);
  json["processed"] = numberOrNull(processedRatio(simulation.bins()));
  addBinShares(json, speciesNames(scene), simulation.bins());
  for (const Observed& observed : simulation.observed())
    json[observed.name] = observedResults(observed);
  json["accuracy"] = certaintyParts(simulation);
  json["base_impulse"] = {simulation.baseImpulse().x(), simulation.baseImpulse().y()};
  json["energy_start"] = outcome.progress.energy_start;
  json["energy_end"] = simulation.energy();
  json["collapses"] = simulation.collapses().count;
  json["max_overlap"] = simulation.maxOverlap();
  json["through_base"] = outcome.progress.through_base;
  if (simulation.plan().steps)
    json["pushed_out"] = simulation.pushedOut();
  json["warnings"] = outcome.warnings;
  return json;
}

}  // namespace ratchet_sieve
