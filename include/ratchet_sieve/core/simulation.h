#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/mean_series.h"
#include "ratchet_sieve/core/observation.h"
#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/segregation.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The vibrating-ratchet feeder: hard disks over an inclined, shaken sawtooth base, advanced from
/// collision to collision. The same definition gives the same bits, however often it is observed
/// and in whatever strides it is advanced.
class Simulation
{
public:
  using CollisionObserver = ratchet_sieve::CollisionObserver;
  using PeriodObserver = ratchet_sieve::PeriodObserver;

  /// Pours the scene. @throws std::invalid_argument if disks of `initial` overlap each other or
  /// the base, or lie outside the machine; the message names them.
  /// @param start_time from which time counts [s]; the scene's phase is that of the drive then
  explicit Simulation(const SceneDefinition& scene, double start_time = 0.0,
                      const PourObserver& pour_observer = {});

  /// The same with more worked out than the scene needs, to see what that costs.
  /// @throws std::invalid_argument also if the plan does not cover the scene
  Simulation(const SceneDefinition& scene, const Plan& plan);

  /// Takes up a run where it was saved, and goes on bit for bit.
  /// @param scene the one that it was saved from; `duration` and the certainty asked for may differ
  /// @throws StateError if the bytes are no state of such a scene
  Simulation(const SceneDefinition& scene, std::string_view saved_state);

  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  const SceneDefinition& scene() const;

  /// What of the model the run works out from its start on.
  const Plan& plan() const;

  double startTime() const;

  /// Simulated time [s], as last asked for.
  double time() const;

  /// See ratchet_sieve::timeScale() [s].
  double timeScale() const;

  /// Executes every event up to and including `time` [s]; earlier times do nothing.
  /// @throws StallError; time() is then when the run came to its end
  void advanceTo(double time);

  /// On how many threads it runs from now on; 0: as many as there are processors. Used by disks that do not
  /// see each other; results do not depend on it.
  void setThreads(std::size_t threads);

  /// Takes effect at time(): the base moves to the setpoint at its slew rate. The caller has checked the
  /// value to be legal: see CommandedQuantity.
  void command(Quantity quantity, double setpoint);
  void setSlewRates(const SlewRates& rates);

  /// Pours `count` more disks of a species on at time(), as low as there is room.
  /// @throws std::invalid_argument if there is no such species, or if its disks are wider than the
  /// machine; nothing has changed then
  void pour(std::size_t species, std::size_t count);

  DriveState base() const;
  std::size_t activeDisks() const;            ///< disks in the machine
  std::vector<DiskState> disks() const;       ///< disks in the machine, by id, at time()
  std::vector<SpeciesBins> bins() const;      ///< per species
  const CollisionCounts& collisions() const;  ///< since the start
  std::uint64_t events() const;               ///< all processed since the start
  std::vector<SpeciesMeans> means() const;    ///< per species, since `settle`; nothing before

  /// When so many blocks of meanSeries() have ended, were none joined [s].
  double blockEnd(std::uint64_t blocks) const;
  MeanSeries meanSeries() const;  ///< what means() are made of, block by block

  bool swings() const;  ///< whether the drive moves the base, now
  /// Of each species now [J]: half its mass times the variance of its disks' velocities, over both
  /// directions. Nothing with fewer than two disks.
  std::vector<std::optional<double>> granularTemperatures() const;
  Eigen::Vector2d baseImpulse() const;  ///< given by the base to the disks since `settle`, 0 before [N s]

  /// disks() into a buffer that is used again and again.
  void disks(std::vector<DiskState>& states) const;

  /// Kinetic + potential energy of disks() [J]. On an inclined periodic base a disk that is wrapped by
  /// a width W changes its potential energy by m g W sin(theta).
  double energy() const;
  bool stalled() const;  ///< whether a collapse ends the run, at the latest when an epoch ends
  const CollapseCounts& collapses() const;
  std::string collapseText() const;  ///< one line with the numbers; empty without a collapse
  double largestEnergy() const;      ///< of a disk at an epoch's end so far, in scales of EnergyWatch
  std::string energyText() const;    ///< one line with the numbers; empty while no disk is out of scale
  double maxOverlap() const;         ///< largest ever seen at a collision or by auditOverlaps() [m]

  /// How often a disk was found behind the base's surface and was pushed out: by Method::STEPS alone.
  std::uint64_t pushedOut() const;

  /// Looks at every disk and every near pair at time(): takes overlaps into maxOverlap() and
  /// returns how many disks are behind the base's surface (always 0, or the engine is wrong).
  std::size_t auditOverlaps();

  /// All that has become of the scene, as bytes; the scene itself is not among them. Saving changes nothing.
  std::string saveState() const;

  /// Calls `observer` after each collision, in the order of time. Empty: nobody watches.
  void observeCollisions(CollisionObserver observer);

  /// Calls `observer` after each whole period of the drive from now on; of a drive of more than 50 Hz, after
  /// some of them: see PeriodWatch. Empty: nobody watches. Changes nothing of the run.
  void observePeriods(PeriodObserver observer);

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ratchet_sieve
