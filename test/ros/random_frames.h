#pragma once

#include <rapidcheck.h>

#include "ratchet_sieve/recording/frames.h"

/// Frames of any content, for properties that hold whatever a run may show.
namespace ratchet_sieve
{

inline double anyNumber()
{
  return *rc::gen::arbitrary<double>();
}

inline std::optional<double> anyOptional()
{
  return *rc::gen::arbitrary<bool>() ? std::optional<double>(anyNumber()) : std::nullopt;
}

/// From 0 to a month, no multiple of a nanosecond.
inline double anyTime()
{
  return *rc::gen::inRange(0, 1 << 30) / 379.0;
}

inline std::vector<std::string> anyNames()
{
  return *rc::gen::container<std::vector<std::string>>(rc::gen::arbitrary<std::string>());
}

inline SceneFrame anySceneFrame()
{
  return {anyTime(),
          anyTime(),
          *rc::gen::arbitrary<std::string>(),
          *rc::gen::arbitrary<std::string>(),
          *rc::gen::arbitrary<std::uint64_t>(),
          *rc::gen::arbitrary<std::string>()};
}

inline ParticleFrame anyParticleFrame()
{
  ParticleFrame frame;
  frame.time = anyTime();
  const int count = *rc::gen::inRange(0, 20);
  for (int k = 0; k < count; ++k)
    frame.disks.push_back({*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>(),
                           anyNumber(), anyNumber(), anyNumber(), anyNumber(), anyNumber(), anyNumber(),
                           anyNumber()});
  return frame;
}

inline BinFrame anyBinFrame()
{
  BinFrame frame;
  frame.time = anyTime();
  frame.species = anyNames();
  for (std::size_t k = 0; k < frame.species.size(); ++k)
    frame.bins.push_back({*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>(),
                          *rc::gen::arbitrary<std::uint64_t>()});
  frame.quality = anyOptional();
  frame.processed = anyOptional();
  return frame;
}

inline BaseFrame anyBaseFrame()
{
  BaseFrame frame;
  frame.time = anyTime();
  for (double* value :
       {&frame.base.inclination, &frame.base.frequency, &frame.base.amplitude,
        &frame.base.commanded_inclination, &frame.base.commanded_frequency, &frame.base.commanded_amplitude,
        &frame.base.phase, &frame.base.displacement, &frame.base.velocity,
        &frame.base.horizontal_displacement, &frame.base.horizontal_velocity})
    *value = anyNumber();
  return frame;
}

inline StatisticsFrame anyStatisticsFrame()
{
  StatisticsFrame frame;
  frame.time = anyTime();
  frame.species = anyNames();
  for (std::size_t k = 0; k < frame.species.size(); ++k)
  {
    frame.means.push_back({anyOptional(), anyOptional(), anyOptional(), anyOptional()});
    frame.granular_temperature.push_back(anyOptional());
  }
  for (std::uint64_t* count :
       {&frame.collisions.disk_disk, &frame.collisions.left_slope, &frame.collisions.right_slope,
        &frame.collisions.apex, &frame.collisions.wall, &frame.events})
    *count = *rc::gen::arbitrary<std::uint64_t>();
  for (double* value : {&frame.window_start, &frame.window_end, &frame.collision_rates.disk_disk,
                        &frame.collision_rates.wall, &frame.real_time_factor, &frame.max_overlap})
    *value = anyNumber();
  return frame;
}

inline CommandFrame anyCommandFrame()
{
  return {anyTime(), static_cast<CommandKind>(*rc::gen::inRange(0, 7)),
          *rc::gen::container<std::vector<double>>(rc::gen::arbitrary<double>()),
          *rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>()};
}

}  // namespace ratchet_sieve
