#pragma once

#include <string>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/live/drives.h"
#include "ratchet_sieve/live/sensors.h"

/// Reads what stands between a machine and its controller, from a tree of keys. The readers throw SceneError,
/// which names source, key, value and what is allowed.
namespace ratchet_sieve
{

/// The sensors: kinds with their settings, such as {scale: {noise: 0.001}, count: {}}. @param source for
/// errors
SensorParameters readSensors(const YAML::Node& root, const std::string& source);

/// The drives: quantities with their settings, such as {inclination: {dead_time: 2.0}}.
DriveParameters readDrives(const YAML::Node& root, const std::string& source);

}  // namespace ratchet_sieve
