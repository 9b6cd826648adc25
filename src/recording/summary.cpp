#include "ratchet_sieve/recording/summary.h"

#include <cmath>

#include "ratchet_sieve/recording/certainty.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/recording/steady.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/statistics/segregation.h"

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
                    {"mean_vx", means[k].mean_vx},
                    {"mean_vx_stderr", means[k].mean_vx_stderr}});
  }
  if (list.empty())
    return;
  species["size_quality"] = bestSeparation(bins).quality();
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
                    {"quality", pair.quality()},
                    {"separation", pair.separation},
                    {"separation_by_mass", pair.by_mass}});
  }
  return list;
}

Json estimateOrNull(const std::optional<Estimate>& estimate)
{
  return estimate ? Json{{"value", estimate->value}, {"half_width", estimate->half_width}}
                  : Json{{"value", nullptr}, {"half_width", nullptr}};
}

Json certaintyParts(const Simulation& simulation)
{
  const Certainty certainty = certaintyOf(simulation);
  const SceneDefinition& scene = simulation.scene();
  Json json;
  json["reached"] = certainty.reached();
  json["confidence"] = scene.accuracy.confidence;
  json["transient"] = certainty.means.transient;
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

/// The estimates of each species in each bin, by number and by mass.
Json portionParts(const std::vector<std::string>& names, const SteadyState& steady,
                  PortionEstimates SteadyBin::*portion)
{
  Json json;
  for (const auto& [bin, of_bin] :
       {std::pair{"left", &SteadySpecies::left}, std::pair{"right", &SteadySpecies::right}})
    for (std::size_t s = 0; s < names.size(); ++s)
    {
      const PortionEstimates& estimates = steady.species[s].*of_bin.*portion;
      json[bin].push_back({{"name", names[s]},
                           {"number", estimateOrNull(estimates.number)},
                           {"mass", estimateOrNull(estimates.mass)}});
    }
  return json;
}

Json steadyParts(const std::vector<std::string>& names, const SteadyState& steady)
{
  std::optional<Estimate> quality = steady.separation;
  if (quality)
    quality->value = std::abs(quality->value);
  Json json{
      {"from", steady.from},
      {"separation", estimateOrNull(steady.separation)},
      {"separation_by_mass", estimateOrNull(steady.separation_by_mass)},
      {"quality", estimateOrNull(quality)},
      {"purity", portionParts(names, steady, &SteadyBin::purity)},
      {"recovery", portionParts(names, steady, &SteadyBin::recovery)},
      {"throughput",
       {{"mass", estimateOrNull(steady.mass_throughput)}, {"number", estimateOrNull(steady.throughput)}}},
      {"inside", estimateOrNull(steady.inside)}};
  for (std::size_t s = 0; s < names.size(); ++s)
  {
    const auto row = [&](const SteadyBin& bin) {
      return Json{{"name", names[s]}, {"number", bin.number}, {"mass", bin.mass}};
    };
    json["exits"]["left"].push_back(row(steady.species[s].left));
    json["exits"]["right"].push_back(row(steady.species[s].right));
  }
  return json;
}

void addSteady(Json& json, const Simulation& simulation, const RunOutcome& outcome)
{
  const Steadiness found = outcome.steadiness ? *outcome.steadiness : steadinessOf(simulation);
  json["steady"] = nullptr;
  json["steady_reason"] = nullptr;
  json["steady_needs"] = found.needs ? Json(*found.needs) : Json();
  if (found.state)
    json["steady"] = steadyParts(speciesNames(simulation.scene()), *found.state);
  else
    json["steady_reason"] = found.reason;
}

}  // namespace

void addObserved(Json& json, const std::vector<Observed>& all)
{
  for (const Observed& observed : all)
  {
    Json& rows = json[observed.name];
    for (const ObservedRow& row : observed.rows)
    {
      Json of_row = {{"name", row.species}};
      for (const ObservedNumber& number : row.numbers)
        of_row[number.name] = number.value;
      for (const ObservedColumn& column : row.table)
        of_row["table"][column.name] = column.values;
      (row.place.empty() ? rows : rows[row.place]).push_back(std::move(of_row));
    }
  }
}

Json planParts(const Plan& plan)
{
  return {{"pairs", plan.pairs},        {"steps", plan.steps}, {"spin", plan.spin},
          {"drive", plan.drive},        {"orbit", plan.orbit}, {"contact_times", plan.contact_times},
          {"search_above_band", false},  // in every summary since 1.0
          {"simd", plan.simd}};
}

void addBinResults(Json& json, const std::vector<std::string>& species, const std::vector<SpeciesBins>& bins)
{
  const PairSeparation best = bestSeparation(bins);
  json["quality"] = best.quality();
  json["separation"] = best.separation;
  json["separation_by_mass"] = best.by_mass;
  json["processed"] = processedRatio(bins);
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
        list.push_back(
            {{"name", species[s]}, {"number", in_bin.number.*share}, {"mass", in_bin.mass.*share}});
      }
    }
}

void addContacts(Json& json, const SceneDefinition& scene, const CollisionCounts& collisions,
                 const FaceContacts& contacts)
{
  json["collisions"] = collisions;
  json["short_to_long"] = collisions.shortToLong(scene.base.slopeAsymmetry());
  if (!scene.base.isSawtooth())
    json["contacts_by_face"] = {{"faces", contacts.face_contacts}, {"corners", contacts.corner_contacts}};
}

void addMeans(Json& species, const SpeciesMeans& means)
{
  const Json all = means;
  species.insert(all.begin(), all.end());
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
  addContacts(json, scene, simulation.collisions(), simulation.faceContacts());
  json["species"] = speciesResults(simulation);
  addBinResults(json, speciesNames(scene), simulation.bins());
  if (scene.species.size() > 2)
    json["pair_qualities"] = pairResults(simulation);
  addObserved(json, simulation.observed());
  json["accuracy"] = certaintyParts(simulation);
  addSteady(json, simulation, outcome);
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
