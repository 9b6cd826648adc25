#include "ratchet_sieve/recording/frames.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{
/// The size classes of each species that has sizes, as an observable.
Observed observedSizeClasses(const Simulation& simulation)
{
  Observed observed{SIZE_CLASSES, {}};
  const std::vector<SizeClass>& classes = simulation.sizeClasses();
  const std::vector<SpeciesMeans> means = simulation.sizeClassMeans();
  for (std::size_t k = 0; k < classes.size();)
  {
    const std::size_t species = classes[k].species;
    ObservedRow row{"", simulation.scene().species[species].name, {}, {}};
    row.table = {{"radius_from", "m", {}},
                 {"radius_to", "m", {}},
                 {"left", "", {}},
                 {"right", "", {}},
                 {"on_base", "", {}},
                 {"mean_vx", "m/s", {}},
                 {"mean_vx_stderr", "m/s", {}}};
    std::vector<SpeciesBins> all;
    for (; k < classes.size() && classes[k].species == species; ++k)
    {
      const SpeciesBins& bins = all.emplace_back(simulation.sizeClassBins()[k]);
      addLine(row.table, {classes[k].smallest, classes[k].largest, static_cast<double>(bins.left),
                          static_cast<double>(bins.right), static_cast<double>(bins.on_base),
                          means[k].mean_vx, means[k].mean_vx_stderr});
    }
    row.numbers = {{"size_quality", "", bestSeparation(all).quality()}};
    observed.rows.push_back(std::move(row));
  }
  return observed;
}

void requireCount(const std::vector<double>& values, std::size_t count)
{
  if (values.size() != count)
    throw std::invalid_argument(fmt::format("a command has {} values, not {}", values.size(), count));
}

/// A NaN is not within bounds.
void requireWithin(double value, const Interval& allowed)
{
  if (!allowed.contains(value))
    throw std::invalid_argument(fmt::format("a command has the value {:g}: must be from {:g} to {:g}", value,
                                            allowed.min, allowed.max));
}

SlewRates slewRatesOf(const std::vector<double>& values)
{
  SlewRates rates;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    rates.*q.slew_rate = values[indexOf(q.quantity)];
  return rates;
}
}  // namespace

std::vector<std::string> speciesNames(const SceneDefinition& scene)
{
  std::vector<std::string> names;
  for (const SpeciesDefinition& species : scene.species)
    names.push_back(species.name);
  return names;
}

SceneFrame makeSceneFrame(const Simulation& simulation)
{
  const SceneDefinition& scene = simulation.scene();
  return {simulation.time(), simulation.startTime(), canonicalYaml(scene), sceneHash(scene), scene.seed,
          version()};
}

ParticleFrame makeParticleFrame(const Simulation& simulation)
{
  ParticleFrame frame{simulation.time(), simulation.disks()};
  if (simulation.sizeClasses().empty() && simulation.scene().feed.disks.empty())
    for (DiskState& disk : frame.disks)
      disk.radius = 0.0;
  return frame;
}

void addRatios(BinFrame& frame)
{
  const PairSeparation best = bestSeparation(frame.bins);
  frame.separation = best.separation;
  frame.quality = best.quality();
  frame.processed = processedRatio(frame.bins);
}

BinFrame makeBinFrame(const Simulation& simulation, double window_start)
{
  BinFrame frame;
  frame.time = simulation.time();
  frame.species = speciesNames(simulation.scene());
  frame.bins = simulation.bins();
  addRatios(frame);
  const ExitWindow window = simulation.exitWindow(window_start);
  frame.window_start = window.start;
  for (const SpeciesBins& bins : window.bins)
  {
    frame.window_left.push_back(bins.left);
    frame.window_right.push_back(bins.right);
  }
  frame.window_separation = bestSeparation(window.bins).separation;
  return frame;
}

BaseFrame makeBaseFrame(const Simulation& simulation)
{
  return {simulation.time(), simulation.base()};
}

ObservedFrame makeObservedFrame(const Simulation& simulation)
{
  ObservedFrame frame{simulation.time(), simulation.observed()};
  if (!simulation.sizeClasses().empty())
    frame.observed.push_back(observedSizeClasses(simulation));
  return frame;
}

bool isObserved(const SceneDefinition& scene)
{
  return !scene.observe.empty() || std::any_of(scene.species.begin(), scene.species.end(),
                                               [](const SpeciesDefinition& s) { return s.size.vary(); });
}

StatisticsFrame makeStatisticsFrame(const Simulation& simulation, const StatisticsWindow& window)
{
  StatisticsFrame frame;
  frame.time = simulation.time();
  frame.window_start = window.start();
  frame.window_end = window.end();
  const std::vector<SpeciesMeans> means = simulation.means();
  const std::vector<std::optional<double>>& temperatures = window.granularTemperatures();
  for (std::size_t i = 0; i < means.size(); ++i)
    frame.species.push_back({simulation.scene().species[i].name, means[i],
                             i < temperatures.size() ? temperatures[i] : std::nullopt});
  frame.collision_rates = window.collisionRates();
  frame.collisions = simulation.collisions();
  frame.faces = simulation.faceContacts();
  frame.events = simulation.events();
  frame.max_overlap = simulation.maxOverlap();
  return frame;
}

CommandFrame setpointCommand(Quantity quantity, double setpoint)
{
  CommandFrame command;
  // The setpoints' kinds come first, in the order of Quantity.
  command.kind = static_cast<CommandKind>(indexOf(quantity));
  command.values = {setpoint};
  return command;
}

CommandFrame slewRateCommand(const SlewRates& rates)
{
  CommandFrame command;
  command.kind = CommandKind::SLEW_RATES;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    command.values.push_back(rates.*q.slew_rate);
  return command;
}

std::optional<Quantity> setpointQuantity(CommandKind kind)
{
  const auto index = static_cast<std::size_t>(kind);
  return index < QUANTITIES ? std::optional(COMMANDED_QUANTITIES[index].quantity) : std::nullopt;
}

std::optional<Stretch> pouredBetween(const CommandFrame& command)
{
  return command.values.size() == 2 ? std::optional(Stretch{command.values[0], command.values[1]})
                                    : std::nullopt;
}

void requireLegal(const CommandFrame& command)
{
  const std::vector<double>& values = command.values;
  if (const auto quantity = setpointQuantity(command.kind))
  {
    requireCount(values, values.size() == 2 ? 2 : 1);
    for (const double value : values)
      requireWithin(value, describe(*quantity).legal);
  }
  if (command.kind == CommandKind::SLEW_RATES)
  {
    requireCount(values, QUANTITIES);
    for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
      requireWithin(values[indexOf(q.quantity)], q.slew_rates);
  }
  if (command.kind != CommandKind::POUR)
    return;
  if (command.count > MOST_POURED)
    throw std::invalid_argument("a command pours " + countText(command.count, "disk"));
  if (!values.empty())
    requireCount(values, 2);
}

void apply(const CommandFrame& command, Simulation& simulation)
{
  if (const auto quantity = setpointQuantity(command.kind))
    return simulation.command(*quantity, command.values.back());
  switch (command.kind)
  {
    case CommandKind::SLEW_RATES:
      return simulation.setSlewRates(slewRatesOf(command.values));
    case CommandKind::POUR:
      return simulation.pour(command.species, command.count, pouredBetween(command));
    default:
      return;
  }
}

}  // namespace ratchet_sieve
