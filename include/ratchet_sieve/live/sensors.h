#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/live/plant.h"

namespace ratchet_sieve
{

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

class Sensor;
using SensorObserver = std::function<void(const Sensor&, const Reading&)>;

/// One sensor. It has its own random numbers: the same scene, seed and motion give the same readings.
class Sensor
{
public:
  /// @param index in SENSOR_LIST @param start_time of the run [s], the time of the first reading
  Sensor(std::size_t index, const SensorSettings& settings, const SceneDefinition& scene, double start_time);

  const SensorInfo& info() const { return info_; }

  /// Of the values of a reading, such as left/scale, or left/count.A.
  const std::vector<std::string>& valueNames() const { return value_names_; }

  /// What it sent last; before, zeros.
  const Reading& sent() const { return sent_; }

  /// A disk leaves. In the order of time, before any later measurement.
  void take(const ExitRecord& exit);

  double nextTime() const;  ///< of a measurement or a sending [s]

  /// Measures and sends what is due. @pre the simulation was not advanced beyond nextTime()
  void read(const Simulation& simulation, const SensorObserver& send = {});

  /// What lies on a scale now counts as nothing. @param time now [s]
  void tare(double time)
  {
    lag_.advanceTo(time);
    tare_ = undisturbed();
  }

  /// What it can suffer: none; stuck (it repeats its last reading); dropout (it says nothing); nan.
  std::vector<std::string> faults() const;
  void setFault(const std::string& fault) { fault_ = fault; }

private:
  double measureTime() const;
  std::vector<double> measured(const Simulation& simulation);
  double undisturbed() const;
  double noise();
  void count(const ExitRecord& exit);
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }

  SensorInfo info_;
  SensorSettings settings_;
  double start_time_;
  double impact_time_;  ///< of a fall from drop_height [s]
  std::vector<std::string> value_names_;
  std::mt19937_64 random_;
  std::uint64_t measurements_ = 0;
  Lag lag_;            ///< of a mass [kg] or disks
  double tare_ = 0.0;  ///< [kg]
  std::vector<double> counts_;
  double counted_until_ = -std::numeric_limits<double>::infinity();  ///< end of the dead time [s]
  std::string fault_ = "none";
  std::vector<double> last_;  ///< values measured, for a sensor that sticks
  std::deque<Reading> under_way_;
  Reading sent_;
};

/// Makes the sensors of a run, in the order of SENSOR_LIST. @param start_time [s]
std::vector<Sensor> makeSensors(const SensorParameters& parameters, const SceneDefinition& scene,
                                double start_time);

/// When the next one measures or sends [s]; infinity without sensors.
double nextTime(const std::vector<Sensor>& sensors);

/// Measures and sends what is due, of all of them.
void readDue(std::vector<Sensor>& sensors, const Simulation& simulation, const SensorObserver& send = {});

/// The place of a disk along the base [m].
double placeAlong(const DriveState& base, const DiskState& disk);

}  // namespace ratchet_sieve
