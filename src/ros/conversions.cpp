#include "ratchet_sieve/ros/conversions.h"

#include <stdexcept>

namespace ratchet_sieve
{
namespace
{
constexpr double LATEST_STAMP = 4294967295.0;  // s

std_msgs::Header headerAt(double time)
{
  std_msgs::Header header;
  header.stamp = stampOf(time);
  header.frame_id = WORLD_FRAME_ID;
  return header;
}

void requireLength(std::size_t length, std::size_t expected, const char* array)
{
  if (length != expected)
    throw std::invalid_argument(std::string(array) + " has " + std::to_string(length) + " entries, not " +
                                std::to_string(expected));
}

/// An optional number as a message carries it: a value and a flag.
void put(const std::optional<double>& from, double& value, std::uint8_t& defined)
{
  value = from.value_or(0.0);
  defined = from.has_value();
}

std::optional<double> get(double value, std::uint8_t defined)
{
  return defined ? std::optional<double>(value) : std::nullopt;
}

SpeciesStatistics toMessage(const std::string& name, const SpeciesMeans& means,
                            const std::optional<double>& granular_temperature)
{
  SpeciesStatistics message;
  message.name = name;
  put(means.mean_vx, message.mean_vx, message.mean_vx_defined);
  put(means.mean_vx_stderr, message.mean_vx_stderr, message.mean_vx_stderr_defined);
  put(means.kinetic_translational, message.kinetic_translational, message.kinetic_translational_defined);
  put(means.kinetic_rotational, message.kinetic_rotational, message.kinetic_rotational_defined);
  put(granular_temperature, message.granular_temperature, message.granular_temperature_defined);
  return message;
}

SpeciesMeans meansOf(const SpeciesStatistics& message)
{
  SpeciesMeans means;
  means.mean_vx = get(message.mean_vx, message.mean_vx_defined);
  means.mean_vx_stderr = get(message.mean_vx_stderr, message.mean_vx_stderr_defined);
  means.kinetic_translational = get(message.kinetic_translational, message.kinetic_translational_defined);
  means.kinetic_rotational = get(message.kinetic_rotational, message.kinetic_rotational_defined);
  return means;
}
}  // namespace

ros::Time stampOf(double time)
{
  return ros::Time(time);
}

bool isStamp(double time)
{
  return time >= 0.0 && time <= LATEST_STAMP;
}

SceneDescription toMessage(const SceneFrame& frame)
{
  SceneDescription message;
  message.header = headerAt(frame.time);
  message.time = frame.time;
  message.start_time = frame.start_time;
  message.yaml = frame.yaml;
  message.scene_hash = frame.scene_hash;
  message.seed = frame.seed;
  message.version = frame.version;
  return message;
}

SceneFrame toFrame(const SceneDescription& message)
{
  return {message.time, message.start_time, message.yaml, message.scene_hash, message.seed, message.version};
}

ParticleStates toMessage(const ParticleFrame& frame)
{
  ParticleStates message;
  message.header = headerAt(frame.time);
  message.time = frame.time;
  const std::size_t count = frame.disks.size();
  message.id.resize(count);
  message.species.resize(count);
  for (auto* array : {&message.x, &message.y, &message.angle, &message.vx, &message.vy, &message.spin,
                      &message.displacement})
    array->resize(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const DiskState& disk = frame.disks[k];
    message.id[k] = disk.id;
    message.species[k] = disk.species;
    message.x[k] = disk.x;
    message.y[k] = disk.y;
    message.angle[k] = disk.angle;
    message.vx[k] = disk.vx;
    message.vy[k] = disk.vy;
    message.spin[k] = disk.spin;
    message.displacement[k] = disk.displacement;
  }
  return message;
}

ParticleFrame toFrame(const ParticleStates& message)
{
  const std::size_t count = message.id.size();
  requireLength(message.species.size(), count, "species");
  requireLength(message.x.size(), count, "x");
  requireLength(message.y.size(), count, "y");
  requireLength(message.angle.size(), count, "angle");
  requireLength(message.vx.size(), count, "vx");
  requireLength(message.vy.size(), count, "vy");
  requireLength(message.spin.size(), count, "spin");
  requireLength(message.displacement.size(), count, "displacement");
  ParticleFrame frame;
  frame.time = message.time;
  frame.disks.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    frame.disks.push_back({message.id[k], message.species[k], message.x[k], message.y[k], message.angle[k],
                           message.vx[k], message.vy[k], message.spin[k], message.displacement[k]});
  return frame;
}

BinCounts toMessage(const BinFrame& frame)
{
  BinCounts message;
  message.header = headerAt(frame.time);
  message.time = frame.time;
  message.species = frame.species;
  for (const SpeciesBins& bins : frame.bins)
  {
    message.left.push_back(bins.left);
    message.right.push_back(bins.right);
    message.on_base.push_back(bins.on_base);
  }
  put(frame.quality, message.quality, message.quality_defined);
  put(frame.processed, message.processed, message.processed_defined);
  return message;
}

BinFrame toFrame(const BinCounts& message)
{
  const std::size_t count = message.species.size();
  requireLength(message.left.size(), count, "left");
  requireLength(message.right.size(), count, "right");
  requireLength(message.on_base.size(), count, "on_base");
  BinFrame frame;
  frame.time = message.time;
  frame.species = message.species;
  for (std::size_t k = 0; k < count; ++k)
    frame.bins.push_back({message.left[k], message.right[k], message.on_base[k]});
  frame.quality = get(message.quality, message.quality_defined);
  frame.processed = get(message.processed, message.processed_defined);
  return frame;
}

BaseState toMessage(const BaseFrame& frame)
{
  BaseState message;
  message.header = headerAt(frame.time);
  message.time = frame.time;
  message.inclination = frame.base.inclination;
  message.frequency = frame.base.frequency;
  message.amplitude = frame.base.amplitude;
  message.commanded_inclination = frame.base.commanded_inclination;
  message.commanded_frequency = frame.base.commanded_frequency;
  message.commanded_amplitude = frame.base.commanded_amplitude;
  message.phase = frame.base.phase;
  message.displacement = frame.base.displacement;
  message.velocity = frame.base.velocity;
  message.horizontal_displacement = frame.base.horizontal_displacement;
  message.horizontal_velocity = frame.base.horizontal_velocity;
  return message;
}

BaseFrame toFrame(const BaseState& message)
{
  BaseFrame frame;
  frame.time = message.time;
  frame.base.inclination = message.inclination;
  frame.base.frequency = message.frequency;
  frame.base.amplitude = message.amplitude;
  frame.base.commanded_inclination = message.commanded_inclination;
  frame.base.commanded_frequency = message.commanded_frequency;
  frame.base.commanded_amplitude = message.commanded_amplitude;
  frame.base.phase = message.phase;
  frame.base.displacement = message.displacement;
  frame.base.velocity = message.velocity;
  frame.base.horizontal_displacement = message.horizontal_displacement;
  frame.base.horizontal_velocity = message.horizontal_velocity;
  return frame;
}

SieveStatistics toMessage(const StatisticsFrame& frame)
{
  SieveStatistics message;
  message.header = headerAt(frame.time);
  message.time = frame.time;
  for (std::size_t k = 0; k < frame.species.size(); ++k)
    message.species.push_back(toMessage(frame.species[k], frame.means[k], frame.granular_temperature[k]));
  message.window_start = frame.window_start;
  message.window_end = frame.window_end;
  message.disk_disk = frame.collisions.disk_disk;
  message.left_slope = frame.collisions.left_slope;
  message.right_slope = frame.collisions.right_slope;
  message.apex = frame.collisions.apex;
  message.wall = frame.collisions.wall;
  message.events = frame.events;
  message.collision_rate = frame.collision_rates.total();
  message.disk_disk_rate = frame.collision_rates.disk_disk;
  message.left_slope_rate = frame.collision_rates.left_slope;
  message.right_slope_rate = frame.collision_rates.right_slope;
  message.apex_rate = frame.collision_rates.apex;
  message.wall_rate = frame.collision_rates.wall;
  message.real_time_factor = frame.real_time_factor;
  message.max_overlap = frame.max_overlap;
  return message;
}

StatisticsFrame toFrame(const SieveStatistics& message)
{
  StatisticsFrame frame;
  frame.time = message.time;
  for (const SpeciesStatistics& species : message.species)
  {
    frame.species.push_back(species.name);
    frame.means.push_back(meansOf(species));
    frame.granular_temperature.push_back(
        get(species.granular_temperature, species.granular_temperature_defined));
  }
  frame.window_start = message.window_start;
  frame.window_end = message.window_end;
  frame.collisions = {message.disk_disk, message.left_slope, message.right_slope, message.apex, message.wall};
  frame.events = message.events;
  frame.collision_rates = {message.disk_disk_rate, message.left_slope_rate, message.right_slope_rate,
                           message.apex_rate, message.wall_rate};
  frame.real_time_factor = message.real_time_factor;
  frame.max_overlap = message.max_overlap;
  return frame;
}

Command toMessage(const CommandFrame& frame)
{
  Command message;
  message.header = headerAt(frame.time);
  message.time = frame.time;
  message.kind = static_cast<std::uint8_t>(frame.kind);
  message.values = frame.values;
  message.species = frame.species;
  message.count = frame.count;
  return message;
}

CommandFrame toFrame(const Command& message)
{
  if (message.kind > Command::UNPAUSE)
    throw std::invalid_argument("a command has the kind " + std::to_string(message.kind) + ", which is none");
  return {message.time, static_cast<CommandKind>(message.kind), message.values, message.species,
          message.count};
}

}  // namespace ratchet_sieve
