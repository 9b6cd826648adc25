#include <algorithm>
#include <cmath>
#include <numeric>

#include "plausibility.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/sizes.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{

/// Warns of counts that are ignored, except for counts of 0 where none are poured: a scene that was read and
/// written out again has those.
void warnOfCounts(const Entry& root, const std::string& winner, bool none_poured, Scene& scene)
{
  const std::vector<Entry> entries = root.at("species").list();
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (entries[i].has("count") && !(none_poured && scene.definition.species[i].count == 0))
      scene.warnings.push_back(
          withId(entries[i].keyOf("count") + " is ignored because " + winner, "ignored-count"));
}

/// Shares by mass over the mean masses, relative to that of the species with the most disks: none is larger
/// than those given, and of equal masses they are those given.
void sharesByNumber(const Entry& root, std::vector<SpeciesDefinition>& species)
{
  const std::vector<Entry> entries = root.at("species").list();
  std::vector<SizeShare> by(entries.size(), SizeShare::NUMBER);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    readValues(entries[i], SHARE_KEYS, by[i]);
    if (by[i] != by[0])
      entries[by[0] == SizeShare::MASS ? 0 : i]
          .at("share_by")
          .refuseValue("must be the same for all species; that of " +
                       species[by[0] == SizeShare::MASS ? i : 0].name + " is number");
  }
  if (by[0] == SizeShare::NUMBER)
    return;
  std::vector<double> masses;
  std::size_t most = 0;
  for (std::size_t i = 0; i < species.size(); ++i)
  {
    masses.push_back(meanMass(species[i]));
    if (species[i].share * masses[most] > species[most].share * masses[i])
      most = i;
  }
  for (std::size_t i = 0; i < species.size(); ++i)
    species[i].share *= masses[most] / masses[i];
}

void splitDensity(const Entry& root, SceneDefinition& scene)
{
  double density = 0.0;
  readValues(root, DENSITY_KEYS, density);
  const Entry entry = root.at("density");
  double diameters = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    diameters += species.share * 2.0 * Sizes(species).meanRadius();
  if (density > 0.0 && diameters <= 0.0)
    entry.refuseValue("needs a species with a share above 0");
  for (SpeciesDefinition& species : scene.species)
  {
    const double count =
        density > 0.0 ? std::round(species.share * density * scene.base.width() / diameters) : 0.0;
    if (count > MOST_DISKS)
      entry.refuseValue("too dense: species " + species.name + " would have more than " +
                        std::to_string(MOST_DISKS) + " disks");
    species.count = static_cast<int>(count);
  }
}

void settleWithinDuration(const Entry& root, const SceneDefinition& scene)
{
  if (scene.settle > scene.duration)
    root.at("settle").refuseValue("must be at most the duration, " + scalarText(scene.duration) +
                                  " s; change settle or duration in the scene, or with --set settle=0 or "
                                  "--duration of sieve_run");
}

void feedHasSpecies(const Entry& root, const SceneDefinition& scene)
{
  const bool none_fed = std::none_of(scene.species.begin(), scene.species.end(),
                                     [](const SpeciesDefinition& species) { return species.share > 0.0; });
  if (scene.feed.rate > 0.0 && none_fed)
    root.at("feed").at("rate").refuseValue("needs a species with a share above 0");
}

/// A row's radius is subject to the rules of a species' radius.
void fedDisksFit(const Entry& root, const SceneDefinition& scene)
{
  if (!root.has("feed"))
    return;
  const Entry feed = root.at("feed");
  if (scene.feed.rate > 0.0 && (feed.has("file") || feed.has("disks")))
    feed.at("rate").refuseValue("must be 0 or absent because a list gives the disks and their times");
  if (scene.feed.disks.empty())
    return;
  const Entry list = feed.at(feed.has("file") ? "file" : "disks");
  const FinestDisk finest = finestDisk(scene);
  for (const FedDisk& disk : scene.feed.disks)
  {
    const auto which = [&disk] {
      return "the disk of radius " + scalarText(disk.radius) + " m fed at " + scalarText(disk.time) + " s ";
    };
    if (2.0 * disk.radius > scene.base.width())
      list.refuse(which() + "is wider than the base, " + scalarText(scene.base.width()) + " m");
    if (disk.radius < finest.radius)
      list.refuse(which() + "is too small: the radius must be at least " + scalarText(finest.radius) +
                  " m in this scene, because " + finest.reason);
  }
}

void disksCountable(const Entry& root, const SceneDefinition& scene)
{
  std::size_t disks = scene.initial.size();
  for (const SpeciesDefinition& species : scene.species)
    disks += static_cast<std::size_t>(species.count);
  if (disks > MOST_DISKS)
    root.at("species").refuse("must have at most " + std::to_string(MOST_DISKS) + " disks in total");
}

/// A disk wider than a periodic base would collide with itself; one wider than a base with ends cannot be
/// poured.
void disksFitMachine(const Entry& root, const SceneDefinition& scene)
{
  const bool poured = scene.feed.any() || std::any_of(scene.species.begin(), scene.species.end(),
                                                      [](const auto& species) { return species.count > 0; });
  int disks = scene.initial.size() > 1 || scene.feed.any() ? 2 : static_cast<int>(scene.initial.size());
  for (const SpeciesDefinition& species : scene.species)
    disks += std::min(species.count, 2);
  const bool matters =
      scene.boundary == Boundary::PERIODIC ? scene.contact.pair_collisions && disks > 1 : poured;
  if (!matters)
    return;
  const std::vector<Entry> entries = root.at("species").list();
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    const double radius = scene.species[i].radius;
    const double largest = Sizes(scene.species[i]).largest();
    const double teeth = 2e-3 * largest / scene.base.toothWidth();
    const bool in_mm = teeth <= 1.0 && teeth >= 0.05;
    const std::string most = std::string("must be at most the base's width (teeth times ") +
                             (scene.base.isSawtooth() ? "tooth_width" : "the profile's") + "), " +
                             scalarText(scene.base.width()) + " m";
    if (2.0 * largest > scene.base.width() && scene.species[i].size.vary())
      entries[i].at("size").refuse("the largest diameter, " + scalarText(2.0 * largest) + " m, " + most +
                                   (in_mm ? "; are its radii in mm?" : ""));
    if (2.0 * radius > scene.base.width())
      entries[i].at("radius").refuseValue(
          "the diameter " + most + (in_mm ? "; did you mean " + scalarText(1e-3 * radius) + " m?" : ""));
  }
}

/// A stretch onto which disks are poured must be on the base.
void stretchOnBase(const Entry& root, const std::string& part, const Stretch& stretch, double width)
{
  if (!root.has(part))
    return;
  const Entry section = root.at(part);
  const auto check = [&](const char* key, double value)
  {
    const bool in_mm = 1e-3 * value <= width && 1e-3 * value >= 0.01 * width;
    if (section.has(key) && value > width)
      section.at(key).refuseValue("must be at most the base's width, " + scalarText(width) + " m" +
                                  (in_mm ? "; did you mean " + scalarText(1e-3 * value) + " m?" : ""));
  };
  check("from", stretch.from);
  check("to", stretch.to);
  if (section.has("to") && stretch.to < stretch.from)
    section.at("to").refuseValue("must be at least " + part + ".from, " + scalarText(stretch.from) + " m");
}

/// Positions and times of the scene must resolve the smallest disk.
void disksFineEnough(const Entry& root, const SceneDefinition& scene)
{
  const FinestDisk finest = finestDisk(scene);
  const std::vector<Entry> entries = root.at("species").list();
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    const double smallest = Sizes(scene.species[i]).smallest();
    const std::string allowed =
        "must be at least " + scalarText(finest.radius) + " m in this scene, because " + finest.reason +
        ": with double precision, smaller disks would overlap by more than 1e-9 of their radius";
    if (smallest < finest.radius && scene.species[i].size.vary())
      entries[i].at("size").refuse("the smallest radius, " + scalarText(smallest) + " m, " + allowed);
    if (smallest < finest.radius)
      entries[i].at("radius").refuseValue(allowed);
  }
}

void tableIsSound(const Entry& species, const SpeciesDefinition& definition)
{
  const std::vector<double>& radii = definition.size.radii;
  const std::vector<double>& weights = definition.size.weights;
  const Entry table = species.at("size");
  if (radii.empty() || radii.size() > MOST_SIZES)
    table.at("radii").refuse("must have 1 to " + std::to_string(MOST_SIZES) + " numbers");
  const std::vector<Entry> entries = table.at("radii").list();
  for (std::size_t k = 1; k < radii.size(); ++k)
    if (!(radii[k] > radii[k - 1]))
      entries[k].refuseValue("must be larger than the radius before, " + scalarText(radii[k - 1]) + " m");
  if (weights.size() != radii.size())
    table.at("weights").refuse("must have as many numbers as radii, " + std::to_string(radii.size()));
  if (std::accumulate(weights.begin(), weights.end(), 0.0) <= 0.0)
    table.at("weights").refuse("needs a weight above 0");
  const auto within = [&radii](double radius) { return radius >= radii.front() && radius <= radii.back(); };
  const double radius = definition.radius;
  if (!within(radius))
    species.at("radius").refuseValue("must be within size.radii, from " + scalarText(radii.front()) + " to " +
                                     scalarText(radii.back()) + " m" +
                                     (within(1e3 * radius) ? "; are size.radii in mm?"
                                      : within(1e-3 * radius)
                                          ? "; did you mean " + scalarText(1e-3 * radius) + " m?"
                                          : ""));
}

/// Every radius is above 0.
void spreadIsSound(const Entry& entry, const SizeDefinition& size)
{
  if (size.distribution == SizeDistribution::UNIFORM && size.spread >= 1.0)
    entry.at("spread").refuseValue("must be below 1: every radius must be above 0");
  if (size.distribution == SizeDistribution::NORMAL && size.spread >= 1.0 / 3.0)
    entry.at("spread").refuseValue(
        "must be below 1/3: every radius must be above 0, and the distribution is cut at 3 standard "
        "deviations");
}

void sizesAreSound(const Entry& root, const SceneDefinition& scene)
{
  const std::vector<Entry> entries = root.at("species").list();
  for (std::size_t i = 0; i < scene.species.size(); ++i)
    if (scene.species[i].size.distribution == SizeDistribution::TABLE)
      tableIsSound(entries[i], scene.species[i]);
    else if (scene.species[i].size.vary())
      spreadIsSound(entries[i].at("size"), scene.species[i].size);
}

}  // namespace

double ballVolume(double radius)
{
  return 4.0 / 3.0 * PI * radius * radius * radius;
}

void resolveCounts(const Entry& root, Scene& scene)
{
  sizesAreSound(root, scene.definition);
  SceneDefinition& definition = scene.definition;
  sharesByNumber(root, definition.species);
  if (!definition.initial.empty())
  {
    if (root.has("density"))
      root.at("density").refuse("must be absent because initial places the disks");
    warnOfCounts(root, "initial places the disks", true, scene);
    for (SpeciesDefinition& species : definition.species)
      species.count = 0;
  }
  else if (root.has("density"))
  {
    warnOfCounts(root, "a density is given", false, scene);
    splitDensity(root, definition);
  }
}

void checkRules(const Entry& root, const SceneDefinition& scene)
{
  settleWithinDuration(root, scene);
  feedHasSpecies(root, scene);
  fedDisksFit(root, scene);
  disksCountable(root, scene);
  disksFitMachine(root, scene);
  disksFineEnough(root, scene);
  stretchOnBase(root, "pour", scene.pour.stretch, scene.base.width());
  stretchOnBase(root, "feed", scene.feed.stretch, scene.base.width());
}

}  // namespace ratchet_sieve
