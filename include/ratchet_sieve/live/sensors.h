#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

enum class SensorKind
{
  SCALE,  ///< under a bin: the mass of what lies in it [kg]
  COUNT,  ///< at an end: the number of disks of each species that have passed
  LEVEL   ///< over the base: the number of disks on a stretch of it
};

constexpr const char* SENSOR_KIND_NAMES[] = {"scale", "count", "level"};  ///< in the order of SensorKind
constexpr std::size_t SENSOR_KINDS = 3;

struct SensorSettings
{
  double rate = 10.0;  ///< readings per second of simulated time
  double delay = 0.0;  ///< from the measurement until it is sent [s]

  // Of scales and levels, in kg and disks.
  double noise = 0.0;          ///< standard deviation
  double resolution = 0.0;     ///< a reading is a multiple of it; 0: any value
  double time_constant = 0.0;  ///< of a first-order lag [s]

  // Of scales.
  double drift = 0.0;        ///< of zero, since the start [kg/h]
  double drop_height = 0.0;  ///< from which disks fall onto it [m]; their impact passes the lag

  // Of counters.
  double dead_time = 0.0;  ///< after a disk that was counted none is [s]
  double miss = 0.0;       ///< probability that a disk is not counted
  double confusion = 0.0;  ///< probability that it is taken for one of another species, all equally likely

  // Of levels: the stretch, along the base [m].
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// In the order of SensorKind; nothing: there is none of the kind.
using SensorParameters = std::array<std::optional<SensorSettings>, SENSOR_KINDS>;

/// One sensor of a machine.
struct SensorInfo
{
  const char* name;  ///< of its topic
  SensorKind kind;
  Exit side;  ///< without meaning for a level
};

constexpr std::array<SensorInfo, 5> SENSOR_LIST = {{
    {"left/scale", SensorKind::SCALE, Exit::LEFT_BIN},
    {"right/scale", SensorKind::SCALE, Exit::RIGHT_BIN},
    {"left/count", SensorKind::COUNT, Exit::LEFT_BIN},
    {"right/count", SensorKind::COUNT, Exit::RIGHT_BIN},
    {"level", SensorKind::LEVEL, Exit::LEFT_BIN},
}};

/// What a sensor says.
struct Reading
{
  double time = 0.0;           ///< of the measurement [s]
  std::vector<double> values;  ///< kg, disks of each species, or disks
};

/// One sensor. It has its own random numbers: the same scene, seed and motion give the same readings.
class Sensor
{
public:
  /// @param index in SENSOR_LIST @param start_time of the run [s], the time of the first reading
  Sensor(std::size_t index, const SensorSettings& settings, const SceneDefinition& scene, double start_time);

  const SensorInfo& info() const { return info_; }

  /// The number of values of a reading.
  std::size_t width() const { return info_.kind == SensorKind::COUNT ? counts_.size() : 1; }

  /// A disk leaves. In the order of time, before any later measurement.
  void take(const ExitRecord& exit);

  double nextTime() const;  ///< of a measurement or a sending [s]

  /// Measures and sends what is due. @pre the simulation was not advanced beyond nextTime()
  void read(const Simulation& simulation, const std::function<void(const Sensor&, const Reading&)>& send);

  /// What lies on a scale now counts as nothing.
  void tare() { tare_ = undisturbed(); }

  /// What it can suffer: none; stuck (it repeats its last reading); dropout (it says nothing); nan.
  std::vector<std::string> faults() const;
  void setFault(const std::string& fault) { fault_ = fault; }

private:
  double measureTime() const;
  std::vector<double> measured(const Simulation& simulation);
  double undisturbed() const;
  double shown(double value);
  void lagTo(double time);
  void count(const ExitRecord& exit);
  double onStretch(const Simulation& simulation) const;
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }

  SensorInfo info_;
  SensorSettings settings_;
  double start_time_;
  double impact_time_;  ///< of a fall from drop_height [s]
  std::mt19937_64 random_;
  std::uint64_t measurements_ = 0;
  double input_ = 0.0;   ///< of the lag: mass [kg] or disks
  double lagged_ = 0.0;  ///< at lag_time_
  double lag_time_;      ///< [s]
  double tare_ = 0.0;    ///< [kg]
  std::vector<double> counts_;
  double counted_until_ = -std::numeric_limits<double>::infinity();  ///< end of the dead time [s]
  std::string fault_ = "none";
  std::vector<double> last_;  ///< values measured, for a sensor that sticks
  std::deque<Reading> under_way_;
};

/// Makes the sensors of a run, in the order of SENSOR_LIST.
std::vector<Sensor> makeSensors(const SensorParameters& parameters, const Simulation& simulation);

/// Of all values of all readings, such as left/scale and left/count.A.
std::vector<std::string> sensedNames(const SensorParameters& parameters, const SceneDefinition& scene);

/// When the next one measures or sends [s]; infinity without sensors.
double nextTime(const std::vector<Sensor>& sensors);

}  // namespace ratchet_sieve
