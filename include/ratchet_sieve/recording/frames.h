#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/statistics_window.h"
#include "ratchet_sieve/statistics/segregation.h"

/// The frames of a run: plain structs that are the same for topics, bags and analysis.
namespace ratchet_sieve
{

/// The scene of the run.
struct SceneFrame
{
  double time = 0.0;        ///< simulated [s]
  double start_time = 0.0;  ///< time at which its disks were poured [s]
  std::string yaml;         ///< resolved: with every key, including defaults
  std::string scene_hash;   ///< hash of the keys that determine the motion
  std::uint64_t seed = 0;
  std::string version;
};

RATCHET_SIEVE_FIELDS(SceneFrame)
{
  RATCHET_SIEVE_FIELD(time, "s");
  RATCHET_SIEVE_FIELD(start_time, "s");
  RATCHET_SIEVE_FIELD(yaml, "");
  RATCHET_SIEVE_FIELD(scene_hash, "");
  RATCHET_SIEVE_FIELD(seed, "");
  RATCHET_SIEVE_FIELD(version, "");
}

/// Every disk in the machine. The radii are 0 if no species of the scene has sizes and feed.disks is empty:
/// see radiusOf().
struct ParticleFrame
{
  double time = 0.0;
  std::vector<DiskState> disks;
};

RATCHET_SIEVE_FIELDS(ParticleFrame)
{
  RATCHET_SIEVE_FIELD(time, "s");
  RATCHET_SIEVE_COLUMNS(disks);
}

/// The radius of a frame's disk [m].
inline double radiusOf(const DiskState& disk, const std::vector<SpeciesDefinition>& species)
{
  return disk.radius > 0.0 ? disk.radius : species[disk.species].radius;
}

/// [kg], as recorded frames have none.
inline double massOf(const DiskState& disk, const std::vector<SpeciesDefinition>& species)
{
  return disk.mass > 0.0 ? disk.mass : species[disk.species].massOf(radiusOf(disk, species));
}

/// The bins: since the start, and what fell into them lately.
struct BinFrame
{
  double time = 0.0;
  std::vector<std::string> species;
  std::vector<SpeciesBins> bins;            ///< per species
  std::optional<double> quality;            ///< Q
  std::optional<double> processed;          ///< P
  std::optional<double> separation;         ///< s
  double window_start = 0.0;                ///< what follows fell after this time [s]
  std::vector<std::uint64_t> window_left;   ///< per species; empty in earlier bags
  std::vector<std::uint64_t> window_right;  ///< as window_left
  std::optional<double> window_separation;  ///< s
};

/// The interval over which frames count what left lately, unless set otherwise [s].
constexpr double BIN_WINDOW = 10.0;

RATCHET_SIEVE_FIELDS(BinFrame)
{
  RATCHET_SIEVE_FIELD(time, "s");
  RATCHET_SIEVE_FIELD(species, "");
  RATCHET_SIEVE_COLUMNS(bins);
  RATCHET_SIEVE_OPTIONAL(quality, "");
  RATCHET_SIEVE_OPTIONAL(processed, "");
  RATCHET_SIEVE_OPTIONAL(separation, "");
  RATCHET_SIEVE_FIELD(window_start, "s");
  RATCHET_SIEVE_FIELD(window_left, "");
  RATCHET_SIEVE_FIELD(window_right, "");
  RATCHET_SIEVE_OPTIONAL(window_separation, "");
}

/// Sets what follows from the counts: s, Q and P.
void addRatios(BinFrame& frame);

/// The base and its drive.
struct BaseFrame
{
  double time = 0.0;
  DriveState base;
};

RATCHET_SIEVE_FIELDS(BaseFrame)
{
  RATCHET_SIEVE_FIELD(time, "s");
  RATCHET_SIEVE_PART(base);
}

/// The statistics of one species.
struct SpeciesRow
{
  std::string name;
  SpeciesMeans means;                          ///< since the end of `settle`
  std::optional<double> granular_temperature;  ///< mean over the window [J]
};

RATCHET_SIEVE_FIELDS(SpeciesRow)
{
  RATCHET_SIEVE_FIELD(name, "");
  RATCHET_SIEVE_PART(means);
  RATCHET_SIEVE_OPTIONAL(granular_temperature, "J");
}

/// Means and rates, and counts since the start.
struct StatisticsFrame
{
  double time = 0.0;
  double window_start = 0.0;  ///< of the means, over whole periods of the drive [s]; see StatisticsWindow
  double window_end = 0.0;    ///< of the means [s]
  std::vector<SpeciesRow> species;
  CollisionCounts collisions;      ///< since the start
  FaceContacts faces;              ///< since the start
  std::uint64_t events = 0;        ///< since the start
  CollisionRates collision_rates;  ///< within the window
  double real_time_factor = 0.0;   ///< achieved since the last frame; 0 in the first frame
  double max_overlap = 0.0;        ///< [m]
};

RATCHET_SIEVE_FIELDS(StatisticsFrame)
{
  RATCHET_SIEVE_FIELD(time, "s");
  RATCHET_SIEVE_FIELD(window_start, "s");
  RATCHET_SIEVE_FIELD(window_end, "s");
  RATCHET_SIEVE_FIELD(species, "");
  RATCHET_SIEVE_PART(collisions);
  RATCHET_SIEVE_PART(faces);
  RATCHET_SIEVE_FIELD(events, "");
  RATCHET_SIEVE_PART(collision_rates);
  RATCHET_SIEVE_FIELD(real_time_factor, "");
  RATCHET_SIEVE_FIELD(max_overlap, "m");
}

/// The name of what is observed of each size class.
constexpr const char* SIZE_CLASSES = "size_classes";

/// What the scene asks to be observed (`observe`), since the end of `settle`; and, where species have sizes,
/// what became of each size class, since the start.
struct ObservedFrame
{
  double time = 0.0;
  std::vector<Observed> observed;
};

RATCHET_SIEVE_FIELDS(ObservedFrame)
{
  RATCHET_SIEVE_FIELD(time, "s");
  RATCHET_SIEVE_FIELD(observed, "");
}

/// Setpoints and actions. The setpoints come first, in the order of Quantity.
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

constexpr std::uint8_t COMMAND_KINDS = 7;

/// A command to a run and the time at which it takes effect. The scene, its seed and its commands determine
/// the run completely.
struct CommandFrame
{
  double time = 0.0;
  CommandKind kind = CommandKind::PAUSE;
  /// The setpoint [rad, Hz, m] and, where a drive gives the base another value, this; for SLEW_RATES the
  /// three rates [unit/s]; for POUR both ends of its stretch [m], or nothing: see pouredBetween().
  std::vector<double> values;
  std::uint32_t species = 0;  ///< of POUR
  std::uint32_t count = 0;    ///< of POUR
};

RATCHET_SIEVE_FIELDS(CommandFrame)
{
  RATCHET_SIEVE_FIELD(time, "s");
  RATCHET_SIEVE_FIELD(kind, "");
  RATCHET_SIEVE_FIELD(values, "");
  RATCHET_SIEVE_FIELD(species, "");
  RATCHET_SIEVE_FIELD(count, "");
}

/// In the order of the scene.
std::vector<std::string> speciesNames(const SceneDefinition& scene);

SceneFrame makeSceneFrame(const Simulation& simulation);
ParticleFrame makeParticleFrame(const Simulation& simulation);

/// @param window_start no earlier exit is in the frame's window [s]; see Simulation::exitWindow()
BinFrame makeBinFrame(const Simulation& simulation,
                      double window_start = -std::numeric_limits<double>::infinity());
BaseFrame makeBaseFrame(const Simulation& simulation);

ObservedFrame makeObservedFrame(const Simulation& simulation);

/// Whether a run of this scene has frames of what is observed.
bool isObserved(const SceneDefinition& scene);

/// Leaves real_time_factor at 0. @param window of this series of frames. @pre window.moveTo(simulation) was
/// called
StatisticsFrame makeStatisticsFrame(const Simulation& simulation, const StatisticsWindow& window);

/// Largest number of disks in one pour command. More is probably a mistake, and a recording with more is
/// damaged: the search for free positions takes seconds and grows with the square of the number.
constexpr std::uint32_t MOST_POURED = 10000;

/// A setpoint [rad, Hz or m] as a command.
CommandFrame setpointCommand(Quantity quantity, double setpoint);

CommandFrame slewRateCommand(const SlewRates& rates);

/// The stretch of a pour command; nothing: that of the scene's pour.
std::optional<Stretch> pouredBetween(const CommandFrame& command);

/// The quantity of a setpoint command; nothing for other commands.
std::optional<Quantity> setpointQuantity(CommandKind kind);

/// Checks a recorded command: setpoints are legal in a scene, slew rates legal for the node.
/// @throws std::invalid_argument
void requireLegal(const CommandFrame& command);

/// Applies a command at the simulation's time; PAUSE and UNPAUSE do nothing. @pre its values are legal
/// @throws std::invalid_argument if there is no such species; the state is then unchanged
void apply(const CommandFrame& command, Simulation& simulation);

}  // namespace ratchet_sieve
