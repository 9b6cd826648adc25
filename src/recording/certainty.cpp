#include "ratchet_sieve/recording/certainty.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/recording/filling.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::uint64_t FIRST_LOOK = 32;      ///< [blocks]
constexpr std::uint64_t BLOCKS_PER_MORE = 5;  ///< checks follow at n and n (1 + 1 / 5) blocks

/// A larger factor is not informative.
constexpr double LARGEST_FACTOR = 1e9;

constexpr const char* RUNS_EMPTY = "the base runs empty, so a longer run does not help";
/// Of an error that is small enough, but from too few blocks.
constexpr const char* TOO_SHORT_TO_TRUST = "the run is too short for a reliable error, ";

/// The largest half-width of the species that have disks; nothing if one is unknown.
std::optional<double> largestHalfWidth(const Simulation& simulation, const SteadyMeans& means)
{
  std::optional<double> largest;
  const std::vector<SpeciesMeans> all = simulation.means();
  for (std::size_t s = 0; s < means.of.size(); ++s)
  {
    if (!all[s].mean_vx)
      continue;
    if (!means.of[s])
      return std::nullopt;
    largest = std::max(largest.value_or(0.0), means.of[s]->estimate.half_width);
  }
  return largest;
}

double timesForTrust(const SteadyMeans& means)
{
  double times = 0.0;
  for (const std::optional<SteadyMean>& mean : means.of)
    if (mean)
      times = std::max(times, mean->times_for_trust);
  return times;
}

Attainment attainmentOfMean(const Simulation& simulation, const SteadyMeans& means)
{
  Attainment attainment;
  if (const std::optional<double> half_width = largestHalfWidth(simulation, means))
    attainment.ratio = *half_width / simulation.scene().accuracy.mean_vx;
  attainment.trusted = means.settled && timesForTrust(means) <= 1.0;
  return attainment;
}

Attainment attainmentOfQuality(const std::optional<SeparationEstimate>& separation, double wanted)
{
  if (!separation)
    return {};
  return {separation->estimate.half_width / wanted, separation->times_for_trust <= 1.0};
}

std::string meanShortfall(const Simulation& simulation, const Certainty& certainty)
{
  const SteadyMeans& means = certainty.means;
  const std::optional<double> ratio = certainty.to_mean_vx->ratio;
  const double wanted = simulation.scene().accuracy.mean_vx;
  const std::string text =
      fmt::format("accuracy.mean_vx = {:g} m/s was not reached within {:g} s: ", wanted, simulation.time());
  if (!ratio || !means.transient)
    return text + (empties(simulation.scene()) ? RUNS_EMPTY : "the run is too short to estimate the error");
  const std::string error =
      *ratio <= 1.0 ? TOO_SHORT_TO_TRUST : fmt::format("± {:.3g} m/s ", *ratio * wanted);
  const std::string found =
      error + fmt::format("over {:.3g} s, the first {:.3g} s after settle cut as transient; ", means.left,
                          *means.transient);
  if (empties(simulation.scene()))
    return text + found + RUNS_EMPTY;
  const double times = std::min(std::max(*ratio * *ratio, timesForTrust(means)), LARGEST_FACTOR);
  const double enough = std::max(*means.transient + means.left * times, CUTS_IN_A_RUN * *means.transient);
  return text + found +
         fmt::format("a duration of about {:.2g} s is needed", simulation.blockEnd(0) + enough);
}

/// The required length or number of runs: the error is inversely proportional to the square root of the
/// counts.
std::string qualityNeed(const Simulation& simulation, const SeparationEstimate& separation)
{
  const double ratio = separation.sampled / simulation.scene().accuracy.quality;
  const double times = std::min(std::max(ratio * ratio, separation.times_for_trust), LARGEST_FACTOR);
  if (simulation.scene().feed.any())
    return fmt::format("a duration of about {:.2g} s is needed", simulation.time() * times);
  const double runs = std::ceil(times * processedRatio(simulation.bins()).value_or(1.0));
  const std::size_t disks = simulation.activeDisks();
  return fmt::format(
      "{} {} not left; about {:g} run{} with other seeds, until all disks have left, would be enough",
      countText(disks, "disk"), disks == 1 ? "has" : "have", runs, runs == 1.0 ? "" : "s");
}

std::string qualityShortfall(const Simulation& simulation,
                             const std::optional<SeparationEstimate>& separation)
{
  const double wanted = simulation.scene().accuracy.quality;
  const std::string text =
      fmt::format("accuracy.quality = {:g} was not reached within {:g} s: ", wanted, simulation.time());
  if (!separation)
    return text + "too few disks have left to estimate the separation and its error";
  const double half_width = separation->estimate.half_width;
  return text + (half_width <= wanted ? TOO_SHORT_TO_TRUST : "") +
         fmt::format("s = {:.3g} ± {:.2g}; ", separation->estimate.value, half_width) +
         qualityNeed(simulation, *separation);
}

}  // namespace

std::optional<bool> Certainty::reached() const
{
  if (!to_mean_vx && !to_quality)
    return std::nullopt;
  return (!to_mean_vx || to_mean_vx->reached()) && (!to_quality || to_quality->reached());
}

std::optional<double> Certainty::ratio() const
{
  std::optional<double> largest;
  for (const std::optional<Attainment>& attainment : {to_mean_vx, to_quality})
  {
    if (attainment && !attainment->ratio)
      return std::nullopt;
    if (attainment)
      largest = std::max(largest.value_or(0.0), *attainment->ratio);
  }
  return largest;
}

Certainty certaintyOf(const Simulation& simulation)
{
  const AccuracyDefinition& wanted = simulation.scene().accuracy;
  std::vector<std::vector<BlockSum>> exits;
  for (const SpeciesFlow& species : simulation.flowSeries().species)
    exits.push_back(leftShare(species.left.number, species.right.number));
  Certainty certainty;
  certainty.means = steadyMeans(simulation.meanSeries(), wanted.confidence);
  certainty.separation = separationEstimate(simulation.bins(), exits, wanted.confidence);
  if (wanted.mean_vx > 0.0)
    certainty.to_mean_vx = attainmentOfMean(simulation, certainty.means);
  if (wanted.quality > 0.0)
    certainty.to_quality = attainmentOfQuality(certainty.separation, wanted.quality);
  return certainty;
}

std::vector<std::string> shortfalls(const Simulation& simulation, const Certainty& certainty)
{
  std::vector<std::string> texts;
  if (certainty.to_mean_vx && !certainty.to_mean_vx->reached())
    texts.push_back(withId(meanShortfall(simulation, certainty), "mean-not-reached"));
  if (certainty.to_quality && !certainty.to_quality->reached())
    texts.push_back(withId(qualityShortfall(simulation, certainty.separation), "quality-not-reached"));
  return texts;
}

std::string unknownErrorText(const Simulation& simulation)
{
  const SceneDefinition& scene = simulation.scene();
  if (empties(scene) || !simulation.plan().pairs)
    return {};
  std::string names;
  const std::vector<SpeciesMeans> means = simulation.means();
  for (std::size_t s = 0; s < means.size(); ++s)
    if (means[s].mean_vx && !means[s].mean_vx_stderr)
      names += (names.empty() ? "" : ", ") + scene.species[s].name;
  if (names.empty())
    return {};
  const double counted = simulation.time() - simulation.blockEnd(0);
  const double enough = std::max(simulation.blockEnd(BlockAverages::MIN_BLOCKS), simulation.time() + counted);
  return fmt::format(
      "mean_vx_stderr of {} is null: {:.3g} s after settle are too short to tell the error; a "
      "duration of about {:.2g} s may do",
      names, counted, enough);
}

double lookFrom(const Simulation& simulation, double time)
{
  std::uint64_t blocks = FIRST_LOOK;
  while (simulation.blockEnd(blocks) < time)
    blocks += (blocks + BLOCKS_PER_MORE - 1) / BLOCKS_PER_MORE;
  return simulation.blockEnd(blocks);
}

}  // namespace ratchet_sieve
