#include "motion_encoding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>

#include "deflate.h"
#include "ratchet_sieve/core/layer.h"

namespace ratchet_sieve
{
namespace
{

constexpr double UNITS_PER_RADIUS = 50.0;   ///< of positions, for the smallest disk
constexpr double UNITS_PER_SECOND = 240.0;  ///< of velocities: units of positions
constexpr double SPIN_UNIT = 6.0;           ///< [rad/s]
constexpr int ANGLE_STEPS = 256;            ///< of a turn
constexpr double RADIUS_UNITS = 1000.0;     ///< for the smallest disk
constexpr double TWO_PI = 6.283185307179586;

/// The largest number that is written: far beyond any machine.
constexpr double LARGEST = 1 << 28;

std::int32_t inUnits(double value, double unit)
{
  return static_cast<std::int32_t>(std::floor(std::clamp(value / unit, -LARGEST, LARGEST) + 0.5));
}

/// Of two numbers whose difference may not be one of 32 bits.
std::int32_t difference(double a, double b)
{
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(a - b)));
}

/// Columns of numbers, one after the other.
class NumberColumns
{
public:
  void add(const std::vector<double>& numbers) { bytes_ += bytePlanes(numbers); }

  template <typename Row, typename Number>
  void add(const std::vector<Row>& rows, const Number& number)
  {
    std::vector<std::int32_t> column;
    column.reserve(rows.size());
    for (const Row& row : rows)
      column.push_back(static_cast<std::int32_t>(number(row)));
    bytes_ += bytePlanes(column);
  }

  std::string deflated() const { return ratchet_sieve::deflated(bytes_); }

private:
  std::string bytes_;
};

/// A disk in consecutive frames.
struct Track
{
  std::size_t first_frame;
  std::vector<const RoundedDisk*> states;
};

std::vector<Track> tracksOf(const std::vector<RoundedFrame>& frames)
{
  std::vector<Track> tracks;
  std::unordered_map<std::uint32_t, std::size_t> last;  ///< track, by id
  for (std::size_t k = 0; k < frames.size(); ++k)
    for (const RoundedDisk& disk : frames[k].disks)
    {
      const auto [found, is_new] = last.try_emplace(disk.id, tracks.size());
      if (is_new || tracks[found->second].first_frame + tracks[found->second].states.size() != k)
      {
        found->second = tracks.size();
        tracks.push_back({k, {}});
      }
      tracks[found->second].states.push_back(&disk);
    }
  return tracks;
}

/// A state and the one before it in its track, which its first state lacks.
struct Step
{
  const RoundedDisk* before;
  const RoundedDisk* now;
  double factor;  ///< units of positions by units of velocities, in the time between
};

std::vector<Step> stepsOf(const std::vector<Track>& tracks, const std::vector<RoundedFrame>& frames)
{
  std::vector<Step> steps;
  for (const Track& track : tracks)
    for (std::size_t i = 0; i < track.states.size(); ++i)
    {
      const std::size_t k = track.first_frame + i;
      const RoundedDisk* before = i > 0 ? track.states[i - 1] : nullptr;
      const double span = i > 0 ? frames[k].time - frames[k - 1].time : 0.0;
      steps.push_back({before, track.states[i], span * UNITS_PER_SECOND});
    }
  return steps;
}

std::int32_t positionStep(const Step& step, std::int32_t RoundedDisk::*position,
                          std::int32_t RoundedDisk::*velocity)
{
  if (step.before == nullptr)
    return step.now->*position;
  const double mean = 0.5 * (step.before->*velocity + step.now->*velocity);
  return difference(step.now->*position, step.before->*position + std::floor(mean * step.factor + 0.5));
}

std::int32_t angleStep(const Step& step)
{
  const std::int32_t before = step.before != nullptr ? step.before->angle : 0;
  const auto turned = static_cast<unsigned>(step.now->angle - before + ANGLE_STEPS / 2);
  return static_cast<std::int32_t>(turned % ANGLE_STEPS) - ANGLE_STEPS / 2;
}

}  // namespace

MotionUnits::MotionUnits(const SceneDefinition& scene)
    : position(smallestRadius(scene) / UNITS_PER_RADIUS),
      velocity(position * UNITS_PER_SECOND),
      radius(smallestRadius(scene) / RADIUS_UNITS)
{
}

RoundedFrame rounded(const ParticleFrame& frame, const SceneDefinition& scene, const MotionUnits& units,
                     std::uint32_t disk_every)
{
  RoundedFrame result{frame.time, {}};
  for (const DiskState& disk : frame.disks)
    if (disk.id % disk_every == 0)
      result.disks.push_back({disk.id, disk.species, inUnits(disk.x, units.position),
                              inUnits(disk.y, units.position), inUnits(disk.vx, units.velocity),
                              inUnits(disk.vy, units.velocity), inUnits(disk.angle, TWO_PI / ANGLE_STEPS),
                              inUnits(disk.spin, SPIN_UNIT),
                              inUnits(radiusOf(disk, scene.species), units.radius)});
  return result;
}

EncodedMotion encode(const std::vector<RoundedFrame>& frames, const MotionUnits& units)
{
  const std::vector<Track> tracks = tracksOf(frames);
  const std::vector<Step> steps = stepsOf(tracks, frames);
  std::vector<double> times;
  times.reserve(frames.size());
  for (const RoundedFrame& frame : frames)
    times.push_back(frame.time);

  NumberColumns columns;
  columns.add(times);
  columns.add(tracks, [](const Track& track) { return track.states.front()->id; });
  columns.add(tracks, [](const Track& track) { return track.states.front()->species; });
  columns.add(tracks, [](const Track& track) { return track.states.front()->radius; });
  columns.add(tracks, [](const Track& track) { return track.first_frame; });
  columns.add(tracks, [](const Track& track) { return track.states.size(); });
  columns.add(steps, [](const Step& step) { return step.now->vx; });
  columns.add(steps, [](const Step& step) { return step.now->vy; });
  columns.add(steps, [](const Step& step) { return positionStep(step, &RoundedDisk::x, &RoundedDisk::vx); });
  columns.add(steps, [](const Step& step) { return positionStep(step, &RoundedDisk::y, &RoundedDisk::vy); });
  columns.add(steps, [](const Step& step) { return step.now->spin; });
  columns.add(steps, angleStep);
  return {{{"frames", frames.size()},
           {"position_unit", units.position},
           {"velocity_unit", units.velocity},
           {"positions_per_velocity", UNITS_PER_SECOND},
           {"spin_unit", SPIN_UNIT},
           {"angle_steps", ANGLE_STEPS},
           {"radius_unit", units.radius},
           {"tracks", tracks.size()},
           {"states", steps.size()}},
          columns.deflated()};
}

}  // namespace ratchet_sieve
