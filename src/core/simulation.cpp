#include "ratchet_sieve/core/simulation.h"

#include <cmath>
#include <utility>

#include "events/engine.h"

namespace ratchet_sieve
{
namespace
{
/// In [-pi, pi) [rad].
double wrappedAngle(double angle)
{
  const double turns = angle / RADIANS_PER_TURN;
  return RADIANS_PER_TURN * (turns - std::floor(turns + 0.5));
}

/// Calls `visit` with the state of each active disk at a local time, one after the other, because an array of
/// all states would need as much memory as the engine itself.
template <typename Visit>
void forEachDiskState(const SystemState& system, double time, Visit&& visit)
{
  const FrameOfBase base = system.motion().at(time);
  // While the base turns all disks are between its ends, because they are wrapped when they pass an end.
  const bool wrapped = system.scene().boundary != Boundary::PERIODIC || system.motion().turning();
  const double gravity = system.scene().gravity;
  for (std::uint32_t slot = 0; slot < system.disks().size(); ++slot)
  {
    if (!system.active(slot))
      continue;
    const Disk& disk = system.disk(slot);
    const DiskRecord& record = system.record(slot);
    const Kinematics now = kinematicsAt(disk, time, gravity);
    const Eigen::Vector2d position = vectorOf(now.position);
    const double widths = wrapped ? 0.0 : system.widthsOutside(base.positionInto(position).x());
    const Image image = widths == 0.0 ? Image() : system.image(-widths, time);
    DiskState state;
    state.id = system.id(slot);
    state.species = disk.species;
    state.radius = disk.radius;
    state.mass = record.properties.mass;
    state.displacement = record.displacement(position.x());
    state.x = position.x() + image.shift.x();
    state.y = position.y() + image.shift.y();
    state.vx = now.velocity[0] + image.velocity.x();
    state.vy = now.velocity[1] + image.velocity.y();
    state.angle = wrappedAngle(record.angleAt(disk, time));
    state.spin = disk.spin;
    visit(state);
  }
}
}  // namespace

Simulation::Simulation(const SceneDefinition& scene, double start_time, const PourObserver& pour_observer)
    : engine_(std::make_unique<Engine>(scene, start_time, pour_observer))
{
}
Simulation::Simulation(const SceneDefinition& scene, std::string_view saved_state)
    : engine_(std::make_unique<Engine>(scene, saved_state))
{
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const SceneDefinition& Simulation::scene() const
{
  return engine_->state().scene();
}

const Plan& Simulation::plan() const
{
  return engine_->state().plan();
}

double Simulation::startTime() const
{
  return engine_->startTime();
}

double Simulation::time() const
{
  return engine_->time();
}

double Simulation::timeScale() const
{
  return engine_->state().timeScale();
}

void Simulation::advanceTo(double time)
{
  engine_->advanceTo(time);
}

void Simulation::command(Quantity quantity, double setpoint)
{
  engine_->changeMotion([=](BaseMotion& m, double now) { m.command(quantity, setpoint, now); });
}

void Simulation::setSlewRates(const SlewRates& rates)
{
  engine_->changeMotion([=](BaseMotion& m, double now) { m.setSlewRates(rates, now); });
}

void Simulation::pour(std::size_t species, std::size_t count, const std::optional<Stretch>& between,
                      const PourObserver& pour_observer)
{
  engine_->pour(species, count, between.value_or(scene().pour.stretch), pour_observer);
}

DriveState Simulation::base() const
{
  return engine_->state().motion().state(engine_->now());
}

std::size_t Simulation::activeDisks() const
{
  return engine_->state().activeCount();
}

std::vector<DiskState> Simulation::disks() const
{
  std::vector<DiskState> states;
  states.reserve(activeDisks());
  forEachDiskState(engine_->state(), engine_->now(),
                   [&](const DiskState& state) { states.push_back(state); });
  return states;
}

void Simulation::forEachDisk(const std::function<void(const DiskState&)>& visit) const
{
  forEachDiskState(engine_->state(), engine_->now(), visit);
}

void Simulation::setThreads(std::size_t threads)
{
  engine_->setThreads(threads);
}

std::vector<SpeciesBins> Simulation::bins() const
{
  return engine_->observers().bins().ofSpecies();
}

void Simulation::keepExits(double length)
{
  engine_->observers().exits().keep(length, time());
}

ExitWindow Simulation::exitWindow(double not_before) const
{
  return engine_->observers().exits().window(time(), not_before);
}

const CollisionCounts& Simulation::collisions() const
{
  return engine_->state().sums().contacts.counts.collisions;
}

FaceContacts Simulation::faceContacts() const
{
  return engine_->observers().faceContacts();
}

std::uint64_t Simulation::events() const
{
  return engine_->events();
}

std::vector<SpeciesMeans> Simulation::means() const
{
  if (!engine_->settled())
    return std::vector<SpeciesMeans>(scene().species.size());
  return engine_->state().sums().averages.means(engine_->now());
}

const std::vector<SizeClass>& Simulation::sizeClasses() const
{
  return engine_->state().sizeClasses();
}

const std::vector<SpeciesBins>& Simulation::sizeClassBins() const
{
  return engine_->observers().bins().ofSizeClasses();
}

std::vector<SpeciesMeans> Simulation::sizeClassMeans() const
{
  if (!engine_->settled())
    return std::vector<SpeciesMeans>(sizeClasses().size());
  return engine_->state().sums().averages.sizeClassMeans(engine_->now());
}

std::vector<Observed> Simulation::observed() const
{
  return engine_->observers().observed(engine_->now(), engine_->settled());
}

double Simulation::blockEnd(std::uint64_t blocks) const
{
  return engine_->blockEnd(blocks);
}

MeanSeries Simulation::meanSeries() const
{
  return engine_->meanSeries();
}

FlowSeries Simulation::flowSeries() const
{
  return engine_->flowSeries();
}

bool Simulation::swings() const
{
  return engine_->state().motion().swings();
}

std::vector<std::optional<double>> Simulation::granularTemperatures() const
{
  return ratchet_sieve::granularTemperatures(engine_->state(), engine_->now());
}

Eigen::Vector2d Simulation::baseImpulse() const
{
  return engine_->settled() ? engine_->state().baseImpulse() : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

double Simulation::energy() const
{
  double energy = 0.0;
  forEachDiskState(engine_->state(), engine_->now(),
                   [&](const DiskState& disk)
                   {
                     const SpeciesDefinition& species = scene().species[disk.species];
                     energy += 0.5 * disk.mass * (disk.vx * disk.vx + disk.vy * disk.vy) +
                               0.5 * species.inertiaOf(disk.mass, disk.radius) * disk.spin * disk.spin +
                               disk.mass * scene().gravity * disk.y;
                   });
  return energy;
}

bool Simulation::stalled() const
{
  return engine_->state().collapseWatch().stops();
}

const CollapseCounts& Simulation::collapses() const
{
  return engine_->state().collapseWatch().counts();
}

std::string Simulation::collapseText() const
{
  const CollapseWatch& watch = engine_->state().collapseWatch();
  return watch.counts().count > 0 ? watch.text() : std::string();
}

double Simulation::largestEnergy() const
{
  return engine_->state().sums().energies.largest();
}

const std::optional<LargeEnergy>& Simulation::implausibleEnergy() const
{
  return engine_->state().sums().energies.first();
}

std::uint64_t Simulation::pushedOut() const
{
  return engine_->state().sums().contacts.counts.pushed_out;
}

double Simulation::maxOverlap() const
{
  return engine_->state().sums().contacts.counts.max_overlap;
}

std::size_t Simulation::auditOverlaps()
{
  return engine_->auditOverlaps();
}

std::string Simulation::saveState() const
{
  StateArchive state;
  engine_->archive(state);
  return state.takeBytes();
}

void Simulation::observeCollisions(CollisionObserver observer)
{
  engine_->state().log().observeCollisions(std::move(observer));
}

void Simulation::observeExits(ExitObserver observer)
{
  engine_->state().log().observeExits(std::move(observer));
}

void Simulation::observePeriods(PeriodObserver observer)
{
  engine_->observePeriods(std::move(observer));
}

}  // namespace ratchet_sieve
