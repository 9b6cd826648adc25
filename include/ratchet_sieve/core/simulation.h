#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/core/sizes.h"
#include "ratchet_sieve/core/state_archive.h"
#include "ratchet_sieve/statistics/block_averages.h"
#include "ratchet_sieve/statistics/flow_series.h"
#include "ratchet_sieve/statistics/segregation.h"

namespace ratchet_sieve
{
/// The largest number of threads that programs accept.
constexpr std::size_t MOST_THREADS = 256;

class Engine;

/// The vibrating-ratchet feeder: hard disks over an inclined, shaken sawtooth base, simulated by events or by
/// integration steps (Method). The same definition gives the same bits, regardless of how often the run is
/// observed and of the arguments of advanceTo().
class Simulation
{
public:
  /// Pours the disks of the scene. @throws std::invalid_argument if disks of `initial` overlap each other or
  /// the base, or lie outside the machine; the message names them.
  /// @param start_time the time of the pour [s]; the scene's phase is the phase of the drive at this time
  explicit Simulation(const SceneDefinition& scene, double start_time = 0.0,
                      const PourObserver& pour_observer = {});

  /// Resumes a saved run, bit for bit.
  /// @param scene the scene of the saved run; only `duration` and the requested accuracy may differ
  /// @throws StateError if the bytes are no state of such a scene
  Simulation(const SceneDefinition& scene, std::string_view saved_state);

  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  const SceneDefinition& scene() const;

  /// The parts of the model that this run computes.
  const Plan& plan() const;

  double startTime() const;

  /// Simulated time [s]: the latest time given to advanceTo().
  double time() const;

  /// See ratchet_sieve::timeScale() [s].
  double timeScale() const;

  /// Executes every event up to and including `time` [s]. An earlier time does nothing.
  /// @throws StallError; time() is then the time at which the run ended
  void advanceTo(double time);

  /// Sets the largest number of threads; 0: one per processor. A run takes as many as its disks are worth; by
  /// steps (Method::STEPS) it takes one. Results do not depend on it.
  void setThreads(std::size_t threads);

  /// Takes effect at time(): the base moves to the setpoint at its slew rate. @pre the value is legal, see
  /// CommandedQuantity.
  void command(Quantity quantity, double setpoint);
  void setSlewRates(const SlewRates& rates);

  /// Pours `count` more disks of a species at time(), at the lowest free positions.
  /// @param between without it, the stretch of the scene's pour
  /// @throws std::invalid_argument if there is no such species, if its disks are wider than the machine, if
  /// the stretch is not on the base, or if there would be more than MOST_DISKS in it; the state is then
  /// unchanged, also if the observer throws
  void pour(std::size_t species, std::size_t count, const std::optional<Stretch>& between = {},
            const PourObserver& pour_observer = {});

  DriveState base() const;
  std::size_t activeDisks() const;        ///< disks in the machine
  std::vector<DiskState> disks() const;   ///< disks in the machine, by id, at time()
  std::vector<SpeciesBins> bins() const;  ///< per species

  /// From now on exits are kept for `length` [s] of simulated time, for exitWindow(). They are no part of the
  /// saved state.
  void keepExits(double length);

  /// What left within the length of keepExits(), but not before that call and not before `not_before` [s].
  /// The exits do not depend on when it is called. Without keepExits() an interval of no length.
  ExitWindow exitWindow(double not_before = -std::numeric_limits<double>::infinity()) const;

  const CollisionCounts& collisions() const;  ///< since the start
  FaceContacts faceContacts() const;          ///< since the start; empty without base.profile
  std::uint64_t events() const;               ///< all events since the start
  std::vector<SpeciesMeans> means() const;    ///< per species, since `settle`; empty before

  /// The classes of size, empty if no species has sizes; their bins, and their means as means().
  const std::vector<SizeClass>& sizeClasses() const;
  const std::vector<SpeciesBins>& sizeClassBins() const;
  std::vector<SpeciesMeans> sizeClassMeans() const;

  /// What the scene asks to be observed, until time(), in the order of `observe`.
  std::vector<Observed> observed() const;

  /// The time at which this number of blocks of meanSeries() has ended, counting blocks of the original
  /// length [s].
  double blockEnd(std::uint64_t blocks) const;
  MeanSeries meanSeries() const;  ///< the series behind means(), in blocks
  FlowSeries flowSeries() const;  ///< of a machine with a feed

  bool swings() const;  ///< whether the drive moves the base at present
  /// The present granular temperature of each species [J]: half its mass times the variance of its disks'
  /// velocities, over both directions. Nothing with fewer than two disks.
  std::vector<std::optional<double>> granularTemperatures() const;
  Eigen::Vector2d baseImpulse() const;  ///< given by the base to the disks since `settle`, 0 before [N s]

  /// Calls `visit` with each of disks(), in their order, without an array of them.
  void forEachDisk(const std::function<void(const DiskState&)>& visit) const;

  /// Kinetic and potential energy of disks() [J]. On an inclined periodic base, the potential energy of a
  /// disk changes by m g W sin(theta) when it is wrapped by a width W.
  double energy() const;
  bool stalled() const;  ///< whether a collapse has ended the run
  const CollapseCounts& collapses() const;
  std::string collapseText() const;  ///< one line with the figures; empty without a collapse
  double largestEnergy() const;      ///< of a disk at the end of an epoch, in scales of the machine
  const std::optional<LargeEnergy>& implausibleEnergy() const;  ///< of the first disk that had one
  double maxOverlap() const;  ///< largest overlap so far, at a collision or in auditOverlaps() [m]

  /// How often a disk was found below the base's surface and moved out; only with Method::STEPS.
  std::uint64_t pushedOut() const;

  /// Checks every disk and every pair of near disks at time(): updates maxOverlap() and returns the number of
  /// disks below the base's surface. Any value other than 0 is an error of the engine.
  std::size_t auditOverlaps();

  /// The state of the run as bytes, without its scene. Saving changes nothing.
  std::string saveState() const;

  /// Calls `observer` after each collision, in the order of time. An empty function removes the observer.
  void observeCollisions(CollisionObserver observer);

  /// Calls `observer` with each disk that leaves, in the order of time. An empty function removes the
  /// observer.
  void observeExits(ExitObserver observer);

  /// Calls `observer` after each whole period of the drive from now on. At more than 50 Hz it is called after
  /// several periods: see PeriodWatch. An empty function removes the observer. The run does not depend on it.
  void observePeriods(PeriodObserver observer);

private:
  std::unique_ptr<Engine> engine_;
};

}  // namespace ratchet_sieve
