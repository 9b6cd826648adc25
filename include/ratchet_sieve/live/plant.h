#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/core/commanded_quantity.h"

/// What stands between a machine and its controller: the settings of drives and sensors, and what they have
/// in common. The readers throw SceneError, which names source, key, value and what is allowed.
namespace ratchet_sieve
{

/// What stands between a setpoint and the base. By default nothing: the base gets the setpoint at once, and
/// follows it at its slew rate. A setpoint passes the members in their order. Units are those of the
/// quantity.
struct DriveSettings
{
  double dead_time = 0.0;                        ///< [s]
  double time_constant = 0.0;                    ///< of a first-order lag [s]
  double resolution = 0.0;                       ///< of the smallest step that the drive can make; 0: any
  std::map<double, double> over_frequency = {};  ///< factors by frequency [Hz]
  double offset = 0.0;                           ///< that the controller does not know
};

using DriveParameters = std::array<DriveSettings, QUANTITIES>;  ///< in the order of Quantity

/// Quantities with their settings, such as {inclination: {dead_time: 2.0}}. @param source for errors
DriveParameters readDrives(const YAML::Node& root, const std::string& source);

enum class SensorKind
{
  SCALE,  ///< under a bin: the mass of what lies in it [kg]
  COUNT,  ///< at an end: the number of disks of each species that have passed
  LEVEL   ///< over the base: the number of disks on a stretch of it
};

constexpr const char* SENSOR_KIND_NAMES[] = {"scale", "count", "level"};  ///< in the order of SensorKind

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

using SensorParameters = std::map<SensorKind, SensorSettings>;  ///< of the kinds that there are

/// Kinds with their settings, such as {scale: {noise: 0.001}, count: {}}. @param source for errors
SensorParameters readSensors(const YAML::Node& root, const std::string& source);

/// A first-order lag. Its solution is exact while the input is constant.
struct Lag
{
  double time_constant = 0.0;  ///< [s]; 0: none
  double time = 0.0;           ///< [s]
  double input = 0.0;
  double output = 0.0;

  void advanceTo(double later)
  {
    const double left = time_constant > 0.0 ? std::exp((time - later) / time_constant) : 0.0;
    output = input + (output - input) * left;
    time = later;
  }
};

/// The nearest multiple of a resolution; the value where that is 0.
inline double inSteps(double value, double resolution)
{
  return resolution > 0.0 ? std::round(value / resolution) * resolution : value;
}

}  // namespace ratchet_sieve
