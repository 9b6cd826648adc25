#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/segregation.h"
#include "ratchet_sieve/core/simulation.h"

/// What a run shows of itself at an instant: plain structs, the same whether they go to a topic, a
/// bag or an analysis.
namespace ratchet_sieve
{

/// The kinds of frames that are taken again and again.
enum class FrameKind
{
  PARTICLES,
  BINS,
  BASE,
  STATISTICS
};

/// The scene as it runs.
struct SceneFrame
{
  double time = 0.0;        ///< simulated [s]
  double start_time = 0.0;  ///< when its disks were poured [s]
  std::string yaml;         ///< resolved: every key, defaults filled in
  std::string scene_hash;   ///< of what decides the motion
  std::uint64_t seed = 0;
  std::string version;
};

/// Every disk in the machine.
struct ParticleFrame
{
  double time = 0.0;
  std::vector<DiskState> disks;
};

/// The bins.
struct BinFrame
{
  double time = 0.0;
  std::vector<std::string> species;
  std::vector<SpeciesBins> bins;    ///< per species
  std::optional<double> quality;    ///< Q
  std::optional<double> processed;  ///< P
};

/// The base and its drive.
struct BaseFrame
{
  double time = 0.0;
  DriveState base;
};

/// Means and rates since the end of `settle`, and counts since the start.
struct StatisticsFrame
{
  double time = 0.0;
  std::vector<std::string> species;
  std::vector<SpeciesMeans> means;  ///< per species
  std::vector<double>
      granular_temperature;     ///< per species, now: half the velocity variance times m [J]; 0 without disks
  CollisionCounts collisions;   ///< since the start
  std::uint64_t events = 0;     ///< since the start
  double collision_rate = 0.0;  ///< since the last frame [1/s of simulated time]
  double real_time_factor = 0.0;  ///< achieved since the last frame; 0 before the second frame
  double max_overlap = 0.0;       ///< [m]
};

/// What a run can be told: first the setpoints, in the order of Quantity.
enum class CommandKind : std::uint8_t
{
  INCLINATION,
  FREQUENCY,
  AMPLITUDE,
  SLEW_RATES,
  POUR,
  PAUSE,
  UNPAUSE
};

/// What a run was told, at the time from which on it holds. With the scene and its seed, all that decides
/// the run.
struct CommandFrame
{
  double time = 0.0;
  CommandKind kind = CommandKind::PAUSE;
  std::vector<double> values;  ///< the setpoint [rad, Hz, m]; of SLEW_RATES the three rates [unit/s]
  std::uint32_t species = 0;   ///< of POUR
  std::uint32_t count = 0;     ///< of POUR
};

/// Granular temperature of each species: half its mass times the variance of its disks' velocities
/// [J], over both directions; 0 without disks.
/// @param masses of the disks of each species [kg]
std::vector<double> granularTemperatures(const std::vector<DiskState>& disks,
                                         const std::vector<double>& masses);

SceneFrame makeSceneFrame(const Simulation& simulation);
ParticleFrame makeParticleFrame(const Simulation& simulation);
BinFrame makeBinFrame(const Simulation& simulation);
BaseFrame makeBaseFrame(const Simulation& simulation);

/// @param disks simulation.disks()
/// @param previous the last frame, for the rates; nothing for the first
/// @param wall_seconds wall time since that frame [s]
StatisticsFrame makeStatisticsFrame(const Simulation& simulation, const std::vector<DiskState>& disks,
                                    const StatisticsFrame* previous, double wall_seconds);

/// The same where nobody has asked for the disks yet.
inline StatisticsFrame makeStatisticsFrame(const Simulation& simulation, const StatisticsFrame* previous,
                                           double wall_seconds)
{
  return makeStatisticsFrame(simulation, simulation.disks(), previous, wall_seconds);
}

}  // namespace ratchet_sieve
