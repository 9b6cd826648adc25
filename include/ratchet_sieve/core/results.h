#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/core/state_archive.h"
#include "ratchet_sieve/statistics/segregation.h"

namespace ratchet_sieve
{

/// The state and the results of a run, as a caller reads them.

/// One disk at the simulation's time, world frame. All members are scalars because each is a column of
/// messages, bags and tables (RATCHET_SIEVE_FIELDS).
struct DiskState
{
  std::uint32_t id = 0;
  std::uint32_t species = 0;
  double x = 0.0;             ///< [m], wrapped into the machine if the boundary is periodic
  double y = 0.0;             ///< [m]
  double angle = 0.0;         ///< counter-clockwise, in [-pi, pi) [rad]
  double vx = 0.0;            ///< [m/s]
  double vy = 0.0;            ///< [m/s]
  double spin = 0.0;          ///< counter-clockwise [rad/s]
  double displacement = 0.0;  ///< unwrapped path along world x since the disk entered [m]
  double radius = 0.0;        ///< [m]; in frames see ParticleFrame
  double mass = 0.0;          ///< [kg]; 0 in recorded frames: that of its species and radius
};

RATCHET_SIEVE_FIELDS(DiskState)
{
  RATCHET_SIEVE_FIELD(id, "");
  RATCHET_SIEVE_FIELD(species, "");
  RATCHET_SIEVE_FIELD(x, "m");
  RATCHET_SIEVE_FIELD(y, "m");
  RATCHET_SIEVE_FIELD(angle, "rad");
  RATCHET_SIEVE_FIELD(vx, "m/s");
  RATCHET_SIEVE_FIELD(vy, "m/s");
  RATCHET_SIEVE_FIELD(spin, "rad/s");
  RATCHET_SIEVE_FIELD(displacement, "m");
  RATCHET_SIEVE_SPARSE(radius, "m");
}

/// The base at the simulation's time.
struct DriveState
{
  double inclination = 0.0;  ///< applied [rad]
  double frequency = 0.0;    ///< applied [Hz]
  double amplitude = 0.0;    ///< applied [m]
  double commanded_inclination = 0.0;
  double commanded_frequency = 0.0;
  double commanded_amplitude = 0.0;
  double phase = 0.0;                    ///< of the drive, in [0, 2 pi) [rad]
  double displacement = 0.0;             ///< Y, upwards in the world [m]
  double velocity = 0.0;                 ///< dY/dt [m/s]
  double horizontal_displacement = 0.0;  ///< along world x [m]
  double horizontal_velocity = 0.0;      ///< along world x [m/s]
};

RATCHET_SIEVE_FIELDS(DriveState)
{
  RATCHET_SIEVE_FIELD(inclination, "rad");
  RATCHET_SIEVE_FIELD(frequency, "Hz");
  RATCHET_SIEVE_FIELD(amplitude, "m");
  RATCHET_SIEVE_FIELD(commanded_inclination, "rad");
  RATCHET_SIEVE_FIELD(commanded_frequency, "Hz");
  RATCHET_SIEVE_FIELD(commanded_amplitude, "m");
  RATCHET_SIEVE_FIELD(phase, "rad");
  RATCHET_SIEVE_FIELD(displacement, "m");
  RATCHET_SIEVE_FIELD(velocity, "m/s");
  RATCHET_SIEVE_FIELD(horizontal_displacement, "m");
  RATCHET_SIEVE_FIELD(horizontal_velocity, "m/s");
}

/// One collision that was executed.
struct CollisionRecord
{
  double time = 0.0;  ///< [s]
  CollisionKind kind = CollisionKind::DISK_DISK;
  std::uint32_t i = 0;
  std::optional<std::uint32_t> j;   ///< empty for the base
  double normal_speed = 0.0;        ///< normal speed of approach, > 0 [m/s]
  double normal_impulse = 0.0;      ///< J_n >= 0 [N s]
  double tangential_impulse = 0.0;  ///< J_t on disk i along its tangent (normal turned by +90 deg) [N s]
};

using CollisionObserver = std::function<void(const CollisionRecord&)>;

/// Where a disk went.
enum class Exit : std::uint8_t
{
  LEFT_BIN,
  RIGHT_BIN
};

constexpr const char* EXIT_NAMES[] = {"left", "right"};  ///< in the order of Exit

inline const char* name(Exit side)
{
  return EXIT_NAMES[static_cast<std::size_t>(side)];
}

RATCHET_SIEVE_FIELDS(SpeciesBins)
{
  RATCHET_SIEVE_FIELD(left, "");
  RATCHET_SIEVE_FIELD(right, "");
  RATCHET_SIEVE_FIELD(on_base, "");
  RATCHET_SIEVE_FIELD(left_mass, "kg");
  RATCHET_SIEVE_FIELD(right_mass, "kg");
}

/// A disk that has left the machine.
struct ExitRecord
{
  double time = 0.0;  ///< [s]
  std::uint32_t id = 0;
  std::uint32_t species = 0;
  double radius = 0.0;  ///< [m]
  double mass = 0.0;    ///< [kg]
  Exit side = Exit::LEFT_BIN;
  double place = 0.0;  ///< of the centre at that time, along world x [m]
};

using ExitObserver = std::function<void(const ExitRecord&)>;

/// Means over the disks of one species and over the time since `settle`.
struct SpeciesMeans
{
  std::optional<double> mean_vx;                ///< sum of displacements / sum of times [m/s]
  std::optional<double> mean_vx_stderr;         ///< standard error [m/s]; see BlockAverages
  std::optional<double> kinetic_translational;  ///< [J], mean over disks and time
  std::optional<double> kinetic_rotational;     ///< [J], mean over disks and time
  std::optional<double> collision_rate;         ///< contacts per disk and time [1/s]
};

RATCHET_SIEVE_FIELDS(SpeciesMeans)
{
  RATCHET_SIEVE_OPTIONAL(mean_vx, "m/s");
  RATCHET_SIEVE_OPTIONAL(mean_vx_stderr, "m/s");
  RATCHET_SIEVE_OPTIONAL(kinetic_translational, "J");
  RATCHET_SIEVE_OPTIONAL(kinetic_rotational, "J");
  RATCHET_SIEVE_OPTIONAL(collision_rate, "1/s");
}

/// A sum of granular temperatures at several instants.
struct TemperatureSum
{
  double sum = 0.0;            ///< [J]
  std::uint64_t instants = 0;  ///< at which the species had at least two disks

  void add(double temperature)
  {
    sum += temperature;
    ++instants;
  }
  void add(const TemperatureSum& other)
  {
    sum += other.sum;
    instants += other.instants;
  }
  std::optional<double> mean() const
  {
    return instants > 0 ? std::optional<double>(sum / static_cast<double>(instants)) : std::nullopt;
  }
};

/// One whole period of the drive, or several.
struct PeriodRecord
{
  double start = 0.0;                        ///< [s]
  double end = 0.0;                          ///< [s]
  double duration = 0.0;                     ///< end - start, without periods left out in between [s]
  CollisionCounts collisions;                ///< during `duration`
  std::vector<TemperatureSum> temperatures;  ///< per species, sampled at equal intervals of the phase
};

using PeriodObserver = std::function<void(const PeriodRecord&)>;

/// A disk whose energy no fall and no elastic bounce off the base explains; see EnergyWatch.
struct LargeEnergy
{
  double time = 0.0;    ///< of the run [s]
  double energy = 0.0;  ///< [J]
  double height = 0.0;  ///< in the world [m]
  double scales = 0.0;  ///< the energy, in those of the machine
  std::uint32_t disk = 0;

  void archive(StateArchive& state) { state(time, energy, height, scales, disk); }
};

/// The number of inelastic collapses or jams; see CollapseWatch.
struct CollapseCounts
{
  std::uint64_t count = 0;
  double first_time = 0.0;  ///< [s]
  std::uint32_t first_disk = 0;

  void archive(StateArchive& state) { state(count, first_time, first_disk); }
};

/// An inelastic collapse of a disk in a scene whose `on_collapse` ends the run; see CollapseAction.
struct StallError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Called repeatedly while disks are poured; may throw to cancel the pour.
using PourObserver = std::function<void(std::size_t poured, std::size_t of)>;

/// What a scene can ask to be observed (`observe`), and what is then seen.

/// A number of an observable; nothing where it is undefined.
struct ObservedNumber
{
  std::string name;
  std::string unit;
  std::optional<double> value;
};

RATCHET_SIEVE_FIELDS(ObservedNumber)
{
  RATCHET_SIEVE_FIELD(name, "");
  RATCHET_SIEVE_FIELD(unit, "");
  RATCHET_SIEVE_OPTIONAL(value, "");
}

/// A column of a row's table.
struct ObservedColumn
{
  std::string name;
  std::string unit;
  std::vector<std::optional<double>> values;
};

RATCHET_SIEVE_FIELDS(ObservedColumn)
{
  RATCHET_SIEVE_FIELD(name, "");
  RATCHET_SIEVE_FIELD(unit, "");
  RATCHET_SIEVE_OPTIONAL(values, "");
}

/// Adds a value to each column.
inline void addLine(std::vector<ObservedColumn>& table, std::initializer_list<std::optional<double>> values)
{
  auto column = table.begin();
  for (const std::optional<double>& value : values)
    (column++)->values.push_back(value);
}

/// What was observed of one species at one place.
struct ObservedRow
{
  std::string place;    ///< the bin, left or right; empty: the whole machine
  std::string species;  ///< its name
  std::vector<ObservedNumber> numbers;
  std::vector<ObservedColumn> table;  ///< columns of the same length
};

RATCHET_SIEVE_FIELDS(ObservedRow)
{
  RATCHET_SIEVE_FIELD(place, "");
  RATCHET_SIEVE_FIELD(species, "");
  RATCHET_SIEVE_FIELD(numbers, "");
  RATCHET_SIEVE_FIELD(table, "");
}

/// One observable: rows by place, of all species in order.
struct Observed
{
  std::string name;
  std::vector<ObservedRow> rows;
};

RATCHET_SIEVE_FIELDS(Observed)
{
  RATCHET_SIEVE_FIELD(name, "");
  RATCHET_SIEVE_FIELD(rows, "");
}

/// What `observe` can name.
std::vector<std::string> observableNames();

}  // namespace ratchet_sieve
