#include "ratchet_sieve/core/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <thread>
#include <tuple>
#include <utility>

#include "disk_states.h"
#include "ratchet_sieve/core/audit.h"
#include "ratchet_sieve/core/energy_watch.h"
#include "ratchet_sieve/core/event_loop.h"
#include "ratchet_sieve/core/machine.h"
#include "ratchet_sieve/core/period_watch.h"
#include "ratchet_sieve/core/placement.h"
#include "ratchet_sieve/core/pour.h"

namespace ratchet_sieve
{

/// What happens to all of the machine at once stands here; what happens to one disk, in the loop.
class Simulation::Implementation
{
public:
  Implementation(const SceneDefinition& scene, const Plan& plan, double start_time,
                 const PourObserver& pour_observer)
      : machine_(scene, plan), random_(scene.seed), energy_watch_(scene), start_(start_time)
  {
    now_ = machine_.startAt(start_);
    if (scene.initial.empty())
      pourDisks(machine_, pourOrder(scene.species, random_), now_, random_, pour_observer);
    else
      placeInitialDisks(machine_, now_);
    loop_ = makeLoop();
    announce(0);
  }

  Implementation(const SceneDefinition& scene, std::string_view saved_state)
      : machine_(scene), random_(scene.seed), loop_(makeLoop()), energy_watch_(scene)
  {
    StateArchive state(saved_state);
    archive(state);
    state.requireEnd();
  }

  void archive(StateArchive& state)
  {
    state(machine_, random_, *loop_, energy_watch_, start_, now_, settled_, blocks_, fed_);
  }

  const Machine& machine() const { return machine_; }
  const EnergyWatch& energyWatch() const { return energy_watch_; }
  double now() const { return now_; }
  double startTime() const { return start_; }
  double time() const { return machine_.epoch().start + now_; }
  std::uint64_t events() const { return loop_->events(); }
  bool settled() const { return settled_; }

  void advanceTo(double time)
  {
    if (!(time >= this->time()))
      return;
    while (true)
    {
      const double target = time - machine_.epoch().start;
      const double next = std::min(target, nextMachineEvent());
      now_ = loop_->advanceTo(next);
      reportSorted();
      if (hasToStop())
      {
        stopAtATimeOfTheRun();
        throw StallError(machine_.collapseWatch().text());
      }
      if (!executeMachineEvent() && next == target)
        return;
    }
  }

  template <typename Command>
  void changeMotion(Command&& command)
  {
    command(machine_.motion(), now_);
    if (const double length = machine_.shortenEpoch(now_); length > 0.0)
      moveZero(length);
    loop_->motionChanged(now_);
    periods_.motionChanged(now_);
  }

  void pour(std::size_t species, std::size_t count)
  {
    const SceneDefinition& scene = machine_.scene();
    if (species >= scene.species.size())
      throw std::invalid_argument("there is no species " + std::to_string(species));
    if (2.0 * scene.species[species].radius > scene.base.width())
      throw std::invalid_argument("disks of species " + scene.species[species].name +
                                  " are wider than the machine: there is no room for them");
    const auto before = static_cast<std::uint32_t>(machine_.disks().size());
    pourDisks(machine_, std::vector<std::uint32_t>(count, static_cast<std::uint32_t>(species)), now_,
              random_);
    announce(before);
  }

  void setThreads(std::size_t threads)
  {
    threads_ = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
    loop_->setThreads(threads_);
  }

  void observeCollisions(CollisionObserver observer)
  {
    observer_ = std::move(observer);
    if (!observer_)
      machine_.observeCollisions(nullptr);
    else if (scenePairs())
      machine_.observeCollisions(observer_);
    else
      machine_.observeCollisions([this](const CollisionRecord& record) { unsorted_.push_back(record); });
  }

  void observePeriods(PeriodObserver observer) { periods_.observe(std::move(observer), now_); }

  std::size_t auditOverlaps()
  {
    const Audit found = audit(machine_, now_);
    machine_.noteOverlap(found.largest_overlap);
    return found.behind_surface;
  }

private:
  std::unique_ptr<EventLoop> makeLoop()
  {
    return scenePairs() ? makePairLoop(machine_) : makeEnsembleLoop(machine_);
  }

  /// What happens to the machine as a whole: when it is next due, local to the epoch [s], and what is done
  /// then.
  struct MachineEvent
  {
    std::optional<double> (Implementation::*due)() const;
    void (Implementation::*execute)();
  };

  /// All of them; of those that are due at one time the first comes first.
  static const auto& machineEvents()
  {
    using I = Implementation;
    static constexpr std::array<MachineEvent, 6> EVENTS = {{{&I::settleDue, &I::settle},
                                                            {&I::blockEndDue, &I::endBlock},
                                                            {&I::periodLookDue, &I::lookAtPeriod},
                                                            {&I::segmentEndDue, &I::beginSegment},
                                                            {&I::feedDue, &I::feed},
                                                            {&I::epochEndDue, &I::endEpoch}}};
    return EVENTS;
  }

  double nextMachineEvent() const
  {
    double next = std::numeric_limits<double>::infinity();
    for (const MachineEvent& event : machineEvents())
      next = std::min(next, (this->*event.due)().value_or(next));
    // Records of an ensemble wait until they are sorted: not too many of them.
    if (observer_ && !scenePairs())
      next = std::min(next, now_ + machine_.timeScale());
    return std::max(next, now_);
  }

  /// Executes one of the events that are due, if any is.
  bool executeMachineEvent()
  {
    for (const MachineEvent& event : machineEvents())
      if (const auto due = (this->*event.due)(); due && *due <= now_)
      {
        (this->*event.execute)();
        return true;
      }
    return false;
  }

  std::optional<double> local(double time) const { return time - machine_.epoch().start; }

  std::optional<double> settleDue() const { return settled_ ? std::nullopt : local(settledTime()); }

  void settle()
  {
    settled_ = true;
    machine_.restartMeans(now_);
  }

  /// The series from which the errors of the means are found goes by the machine's time scale. Disks that do
  /// not see each other are independent, and need none.
  std::optional<double> blockEndDue() const
  {
    if (!settled_ || !scenePairs())
      return std::nullopt;
    return local(settledTime() + static_cast<double>(blocks_ + 1) * machine_.timeScale());
  }

  void endBlock()
  {
    ++blocks_;
    machine_.endPieceOfMeans(now_);
  }

  std::optional<double> periodLookDue() const { return periods_.next(); }

  void lookAtPeriod() { periods_.look(now_); }

  std::optional<double> segmentEndDue() const { return machine_.motion().nextChange(); }

  void beginSegment()
  {
    changeMotion([](BaseMotion& motion, double now) { motion.beginSegment(now); });
  }

  std::optional<double> feedDue() const
  {
    const double rate = machine_.scene().feed.rate;
    return rate > 0.0 ? local(start_ + static_cast<double>(fed_ + 1) / rate) : std::nullopt;
  }

  void feed()
  {
    ++fed_;
    pour(drawSpecies(machine_.scene().species, random_), 1);
  }

  std::optional<double> epochEndDue() const { return machine_.epoch().length; }

  void endEpoch()
  {
    const bool moving = machine_.motion().nextChange().has_value();
    energy_watch_.look(machine_, now_);
    moveZero(machine_.epoch().length);
    if (machine_.mostlyLeft())
      giveUpPlaces();
    else if (loop_->outgrown(now_) || moving)
      loop_->motionChanged(now_);
  }

  void moveZero(double length)
  {
    machine_.rebase(length);
    loop_->rebase(length);
    periods_.rebase(length);
    now_ -= length;
  }

  double settledTime() const { return start_ + machine_.scene().settle; }

  bool scenePairs() const { return machine_.plan().pairs; }

  /// A machine that is fed for ever would else need more and more memory, and time to look through it.
  void giveUpPlaces()
  {
    machine_.giveUpPlaces();
    const std::uint64_t events = loop_->events();
    loop_ = makeLoop();
    loop_->setEvents(events);
    loop_->setThreads(threads_);
    announce(0);
  }

  /// An ensemble's disks do not come to a collapse in the order of time: it is stopped at the end of an
  /// epoch, in whatever strides it is advanced.
  bool hasToStop() const
  {
    const CollapseWatch& watch = machine_.collapseWatch();
    return watch.stops() && (scenePairs() || now_ >= machine_.epoch().length);
  }

  /// An epoch's times are finer than the run's: the run ends at the next of its own, so that another that is
  /// asked to come to time() comes to the same bits.
  void stopAtATimeOfTheRun()
  {
    const double epoch_start = machine_.epoch().start;
    double end = time();
    if (end - epoch_start < now_)
      end = std::nextafter(end, std::numeric_limits<double>::infinity());
    now_ = end - epoch_start;
  }

  void reportSorted()
  {
    std::stable_sort(unsorted_.begin(), unsorted_.end(),
                     [](const CollisionRecord& a, const CollisionRecord& b)
                     { return std::tie(a.time, a.i) < std::tie(b.time, b.i); });
    for (const CollisionRecord& record : unsorted_)
      observer_(record);
    unsorted_.clear();
  }

  void announce(std::uint32_t first)
  {
    for (std::uint32_t id = first; id < machine_.disks().size(); ++id)
      loop_->added(id, now_);
  }

  Machine machine_;
  Random random_;
  std::unique_ptr<EventLoop> loop_;
  EnergyWatch energy_watch_;
  double start_ = 0.0;
  double now_ = 0.0;  ///< local to the epoch [s]
  bool settled_ = false;
  std::uint64_t blocks_ = 0;  ///< of the series of means that have ended
  std::uint64_t fed_ = 0;
  std::size_t threads_ = 1;
  PeriodWatch periods_{machine_};
  CollisionObserver observer_;
  std::vector<CollisionRecord> unsorted_;  ///< an ensemble's, disk by disk
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
  return implementation_->machine().collisions();
}

std::uint64_t Simulation::events() const
{
  return implementation_->events();
}

std::vector<SpeciesMeans> Simulation::means() const
{
  if (!implementation_->settled())
    return std::vector<SpeciesMeans>(scene().species.size());
  return implementation_->machine().means(implementation_->now());
}

bool Simulation::swings() const
{
  return implementation_->machine().motion().swings();
}

std::vector<std::optional<double>> Simulation::granularTemperatures() const
{
  return ratchet_sieve::granularTemperatures(implementation_->machine(), implementation_->now());
}

double Simulation::baseImpulseX() const
{
  return implementation_->settled() ? implementation_->machine().baseImpulseX() : 0.0;
}

double Simulation::baseImpulseY() const
{
  return implementation_->settled() ? implementation_->machine().baseImpulseY() : 0.0;
}

double Simulation::energy() const
{
  double energy = 0.0;
  forEachDiskState(implementation_->machine(), implementation_->now(),
                   [&](const DiskState& disk)
                   {
                     const SpeciesDefinition& species = scene().species[disk.species];
                     energy += 0.5 * species.mass * (disk.vx * disk.vx + disk.vy * disk.vy) +
                               0.5 * species.inertia() * disk.spin * disk.spin +
                               species.mass * scene().gravity * disk.y;
                   });
  return energy;
}

bool Simulation::stalled() const
{
  return implementation_->machine().collapseWatch().stops();
}

const CollapseCounts& Simulation::collapses() const
{
  return implementation_->machine().collapseWatch().counts();
}

std::string Simulation::collapseText() const
{
  const CollapseWatch& watch = implementation_->machine().collapseWatch();
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

double Simulation::maxOverlap() const
{
  return implementation_->machine().maxOverlap();
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
