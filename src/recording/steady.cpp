#include "ratchet_sieve/recording/steady.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ratchet_sieve/recording/filling.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/recording/run_warnings.h"

namespace ratchet_sieve
{
namespace
{

/// With fewer disks neither a drift of what leaves nor its correlation can be seen.
constexpr double FEWEST_EXITS = 20.0;

std::vector<BlockSum> sumOver(const std::vector<BlockSum>& a, const std::vector<BlockSum>& b)
{
  std::vector<BlockSum> blocks = a;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    blocks[k].sum += b[k].sum;
  return blocks;
}

BinFlow operator+(const BinFlow& a, const BinFlow& b)
{
  return {sumOver(a.number, b.number), sumOver(a.mass, b.mass)};
}

/// @param others what is not in the part
Portion portionOf(const BinFlow& part, const BinFlow& others)
{
  return {leftShare(part.number, others.number), leftShare(part.mass, others.mass)};
}

double massOf(const BinFlow& flow)
{
  return sumOf(flow.mass).sum;
}

double numberOf(const BinFlow& flow)
{
  return sumOf(flow.number).sum;
}

/// The steady part of a series.
class SteadyPart
{
public:
  SteadyPart(const FlowSeries& series, std::size_t first, const SceneDefinition& scene) : scene_(scene)
  {
    const auto bin_from = [first](const BinFlow& bin) {
      return BinFlow{blocksFrom(bin.number, first), blocksFrom(bin.mass, first)};
    };
    for (const SpeciesFlow& species : series.species)
    {
      species_.push_back(
          {bin_from(species.left), bin_from(species.right), blocksFrom(species.inside, first)});
      inside_ = inside_.empty() ? species_.back().inside : sumOver(inside_, species_.back().inside);
      exits_ = exits_.number.empty() ? bothBins(species_.size() - 1) : exits_ + bothBins(species_.size() - 1);
    }
    for (const SpeciesFlow& species : species_)
      correlation_ = std::max(
          correlation_, correlationOf(portionOf(species.left, species.right), confidence()).value_or(1.0));
  }

  double exits() const { return numberOf(exits_); }

  std::vector<SpeciesBins> bins() const
  {
    std::vector<SpeciesBins> bins;
    for (const SpeciesFlow& species : species_)
    {
      SpeciesBins& of_species = bins.emplace_back();
      of_species.left = static_cast<std::uint64_t>(numberOf(species.left));
      of_species.right = static_cast<std::uint64_t>(numberOf(species.right));
      of_species.left_mass = massOf(species.left);
      of_species.right_mass = massOf(species.right);
    }
    return bins;
  }

  /// Of a pair of species; nothing if what leaves is too correlated.
  std::optional<Estimate> separation(const PairSeparation& pair) const
  {
    std::vector<std::vector<BlockSum>> exits;
    for (const SpeciesFlow& species : species_)
      exits.push_back(leftShare(species.left.number, species.right.number));
    const std::optional<double> of_blocks =
        correlatedHalfWidth(separationDeviations(exits[pair.first], exits[pair.second]), confidence());
    std::optional<SeparationEstimate> found = separationEstimate(bins(), exits, confidence());
    if (!found || !of_blocks)
      return std::nullopt;
    return Estimate{found->estimate.value, std::max(found->estimate.half_width, *of_blocks)};
  }

  /// The error is at least that of disks that are fed and move independently of each other; see fillingOf().
  Estimate inside() const
  {
    const BlockSum all = sumOf(inside_);
    const double independent = std::sqrt(2.0 * all.sum * all.sum / (exits() + 1.0)) / all.weight;
    Estimate estimate{all.sum / all.weight, halfWidthOver(confidence(), 0) * independent};
    if (const std::optional<double> of_blocks = correlatedHalfWidth(inside_, confidence()))
      estimate.half_width = std::max(estimate.half_width, *of_blocks);
    return estimate;
  }

  std::optional<Estimate> throughput() const { return rate(exits_.number); }
  std::optional<Estimate> massThroughput() const { return rate(exits_.mass); }

  std::vector<SteadySpecies> species() const
  {
    std::vector<SteadySpecies> all;
    for (std::size_t s = 0; s < species_.size(); ++s)
    {
      const SpeciesFlow& flow = species_[s];
      all.push_back({binOf(s, &SpeciesFlow::left, flow.right), binOf(s, &SpeciesFlow::right, flow.left)});
    }
    return all;
  }

private:
  double confidence() const { return scene_.accuracy.confidence; }
  BinFlow bothBins(std::size_t species) const { return species_[species].left + species_[species].right; }

  /// Of what left of a species; of the scene if none did [kg].
  double meanMass(std::size_t species) const
  {
    const BinFlow both = bothBins(species);
    return numberOf(both) > 0.0 ? massOf(both) / numberOf(both) : scene_.species[species].mass;
  }

  std::optional<Estimate> rate(const std::vector<BlockSum>& blocks) const
  {
    const std::optional<double> half_width = correlatedHalfWidth(blocks, confidence());
    if (!half_width)
      return std::nullopt;
    const BlockSum all = sumOf(blocks);
    return Estimate{all.sum / all.weight, *half_width};
  }

  /// @param elsewhere the same species in the other bin
  SteadyBin binOf(std::size_t species, BinFlow SpeciesFlow::*side, const BinFlow& elsewhere) const
  {
    const BinFlow& here = species_[species].*side;
    SteadyBin bin{numberOf(here), massOf(here), {}, {}};
    const double each = meanMass(species);
    bin.recovery = portionEstimates(portionOf(here, elsewhere), correlation_, each, each, confidence());
    BinFlow others{std::vector<BlockSum>(here.number.size()), std::vector<BlockSum>(here.mass.size())};
    double others_each = 0.0;
    for (std::size_t s = 0; s < species_.size(); ++s)
    {
      if (s == species)
        continue;
      others = others + species_[s].*side;
      others_each += meanMass(s) / static_cast<double>(species_.size() - 1);
    }
    bin.purity = portionEstimates(portionOf(here, others), correlation_, each, others_each, confidence());
    return bin;
  }

  const SceneDefinition& scene_;
  std::vector<SpeciesFlow> species_;
  BinFlow exits_;                 ///< of all species, in both bins
  std::vector<BlockSum> inside_;  ///< of all species
  double correlation_ = 1.0;      ///< the largest of the species'
};

/// With the distances to the farther ends of both intervals, added as Newcombe does.
std::optional<Estimate> difference(const std::optional<Estimate>& a, const std::optional<Estimate>& b)
{
  if (!a || !b)
    return std::nullopt;
  return Estimate{a->value - b->value, std::hypot(a->half_width, b->half_width)};
}

/// Why no steady state can be looked for; empty if it can.
std::string whyNone(const Simulation& simulation)
{
  const SceneDefinition& scene = simulation.scene();
  if (!scene.feed.any())
    return "no feed: nothing comes in";
  if (scene.boundary == Boundary::PERIODIC)
    return "no end: nothing leaves a periodic base";
  return chokeText(simulation);
}

}  // namespace

Steadiness steadinessOf(const Simulation& simulation)
{
  if (const std::string reason = whyNone(simulation); !reason.empty())
    return {std::nullopt, reason};
  const SceneDefinition& scene = simulation.scene();
  const FlowSeries series = simulation.flowSeries();
  const Filling filling = fillingOf(series, speciesNames(scene));
  if (!filling.blocks)
    return {std::nullopt, filling.reason, filling.needs};
  const SteadyPart part(series, *filling.blocks, scene);
  SteadyState state;
  state.from = series.start + static_cast<double>(*filling.blocks) * series.block_time;
  if (part.exits() < FEWEST_EXITS)
    return {std::nullopt, fmt::format("too few left: {:g} since {:.4g} s", part.exits(), state.from)};
  if (const PairSeparation pair = bestSeparation(part.bins()); pair.separation)
  {
    state.pair = pair;
    state.separation = part.separation(pair);
    if (!state.separation)
      return {std::nullopt, "not settled: what leaves changes more slowly than the run can tell"};
  }
  state.inside = part.inside();
  state.throughput = part.throughput();
  state.mass_throughput = part.massThroughput();
  state.species = part.species();
  if (state.pair)
    state.separation_by_mass = difference(state.species[state.pair->first].left.recovery.mass,
                                          state.species[state.pair->second].left.recovery.mass);
  return {state, ""};
}

std::string steadyText(const Simulation& simulation, const Steadiness& steadiness, const Certainty& certainty)
{
  if (!steadiness.state || !steadiness.state->separation || !certainty.separation)
    return {};
  const PairSeparation pair = bestSeparation(simulation.bins());
  const SteadyState& state = *steadiness.state;
  const Estimate& steady = *state.separation;
  const Estimate& whole = certainty.separation->estimate;
  if (pair.first != state.pair->first || pair.second != state.pair->second ||
      std::abs(whole.value - steady.value) <= std::max(whole.half_width, steady.half_width))
    return {};
  return fmt::format(
      "the separation since the start, {:.3g} ± {:.2g}, is not that of the filled machine: since {:.3g} s "
      "it "
      "is {:.3g} ± {:.2g} (steady.separation)",
      whole.value, whole.half_width, state.from, steady.value, steady.half_width);
}

}  // namespace ratchet_sieve
