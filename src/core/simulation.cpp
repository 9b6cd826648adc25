#include "ratchet_sieve/core/simulation.h"

#include <utility>

#include "events/engine.h"
#include "state/disk_states.h"

namespace ratchet_sieve
{

class Simulation::Implementation : public Engine
{
  using Engine::Engine;
};

Simulation::Simulation(const SceneDefinition& scene, double start_time, const PourObserver& pour_observer)
    : implementation_(std::make_unique<Implementation>(scene, planOf(scene), start_time, pour_observer))
{
}
Simulation::Simulation(const SceneDefinition& scene, const Plan& plan)
    : implementation_(std::make_unique<Implementation>(scene, plan, 0.0, PourObserver()))
{
}
Simulation::Simulation(const SceneDefinition& scene, std::string_view saved_state)
    : implementation_(std::make_unique<Implementation>(scene, saved_state))
{
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const SceneDefinition& Simulation::scene() const
{
  return implementation_->machine().scene();
}

const Plan& Simulation::plan() const
{
  return implementation_->machine().plan();
}

double Simulation::startTime() const
{
  return implementation_->startTime();
}

double Simulation::time() const
{
  return implementation_->time();
}

double Simulation::timeScale() const
{
  return implementation_->machine().timeScale();
}

void Simulation::advanceTo(double time)
{
  implementation_->advanceTo(time);
}

void Simulation::command(Quantity quantity, double setpoint)
{
  implementation_->changeMotion([=](BaseMotion& m, double now) { m.command(quantity, setpoint, now); });
}

void Simulation::setSlewRates(const SlewRates& rates)
{
  implementation_->changeMotion([=](BaseMotion& m, double now) { m.setSlewRates(rates, now); });
}

void Simulation::pour(std::size_t species, std::size_t count)
{
  implementation_->pour(species, count);
}

DriveState Simulation::base() const
{
  return implementation_->machine().motion().state(implementation_->now());
}

std::size_t Simulation::activeDisks() const
{
  return implementation_->machine().activeCount();
}

std::vector<DiskState> Simulation::disks() const
{
  std::vector<DiskState> states;
  disks(states);
  return states;
}

void Simulation::disks(std::vector<DiskState>& states) const
{
  states.clear();
  states.reserve(activeDisks());
  forEachDiskState(implementation_->machine(), implementation_->now(),
                   [&](const DiskState& state) { states.push_back(state); });
}

void Simulation::setThreads(std::size_t threads)
{
  implementation_->setThreads(threads);
}

std::vector<SpeciesBins> Simulation::bins() const
{
  return implementation_->machine().bins();
}

const CollisionCounts& Simulation::collisions() const
{
  return implementation_->record().counts().collisions;
}

std::uint64_t Simulation::events() const
{
  return implementation_->events();
}

std::vector<SpeciesMeans> Simulation::means() const
{
  if (!implementation_->settled())
    return std::vector<SpeciesMeans>(scene().species.size());
  return implementation_->record().means(implementation_->now());
}

const std::vector<SizeClass>& Simulation::sizeClasses() const
{
  return implementation_->machine().sizeClasses();
}

const std::vector<SpeciesBins>& Simulation::sizeClassBins() const
{
  return implementation_->machine().sizeClassBins();
}

std::vector<SpeciesMeans> Simulation::sizeClassMeans() const
{
  if (!implementation_->settled())
    return std::vector<SpeciesMeans>(sizeClasses().size());
  return implementation_->record().sizeClassMeans(implementation_->now());
}

double Simulation::blockEnd(std::uint64_t blocks) const
{
  return implementation_->blockEnd(blocks);
}

MeanSeries Simulation::meanSeries() const
{
  return implementation_->meanSeries();
}

bool Simulation::swings() const
{
  return implementation_->machine().motion().swings();
}

std::vector<std::optional<double>> Simulation::granularTemperatures() const
{
  return ratchet_sieve::granularTemperatures(implementation_->machine(), implementation_->now());
}

Eigen::Vector2d Simulation::baseImpulse() const
{
  return implementation_->settled() ? implementation_->record().impulses().total()
                                    : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

double Simulation::energy() const
{
  double energy = 0.0;
  forEachDiskState(implementation_->machine(), implementation_->now(),
                   [&](const DiskState& disk)
                   {
                     const SpeciesDefinition& species = scene().species[disk.species];
                     const double mass = species.massOf(disk.radius);
                     energy += 0.5 * mass * (disk.vx * disk.vx + disk.vy * disk.vy) +
                               0.5 * species.inertiaOf(mass, disk.radius) * disk.spin * disk.spin +
                               mass * scene().gravity * disk.y;
                   });
  return energy;
}

bool Simulation::stalled() const
{
  return implementation_->collapseWatch().stops();
}

const CollapseCounts& Simulation::collapses() const
{
  return implementation_->collapseWatch().counts();
}

std::string Simulation::collapseText() const
{
  const CollapseWatch& watch = implementation_->collapseWatch();
  return watch.counts().count > 0 ? watch.text() : std::string();
}

double Simulation::largestEnergy() const
{
  return implementation_->energyWatch().largest();
}

std::string Simulation::energyText() const
{
  return implementation_->energyWatch().text();
}

std::uint64_t Simulation::pushedOut() const
{
  return implementation_->record().counts().pushed_out;
}

double Simulation::maxOverlap() const
{
  return implementation_->record().counts().max_overlap;
}

std::size_t Simulation::auditOverlaps()
{
  return implementation_->auditOverlaps();
}

std::string Simulation::saveState() const
{
  StateArchive state;
  implementation_->archive(state);
  return state.takeBytes();
}

void Simulation::observeCollisions(CollisionObserver observer)
{
  implementation_->observeCollisions(std::move(observer));
}

void Simulation::observePeriods(PeriodObserver observer)
{
  implementation_->observePeriods(std::move(observer));
}

}  // namespace ratchet_sieve
