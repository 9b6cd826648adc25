#pragma once

#include "ratchet_sieve/analysis/run_analysis.h"

namespace ratchet_sieve
{

inline DiskState diskAt(std::uint32_t id, std::uint32_t species, double displacement)
{
  DiskState disk;
  disk.id = id;
  disk.species = species;
  disk.displacement = displacement;
  return disk;
}

inline ParticleFrame particlesAt(double time, const std::vector<DiskState>& disks)
{
  ParticleFrame frame;
  frame.time = time;
  frame.disks = disks;
  return frame;
}

/// A small result with every part filled in by hand.
inline RunResult handMadeResult()
{
  RunResult result;
  result.scene_frame.scene_hash = "0123456789abcdef";
  result.scene_frame.seed = 7;
  result.scene_frame.version = "1.2.3";
  result.scene.base.asymmetry = 0.25;
  result.scene.boundary = Boundary::OPEN;
  result.end = 2.5;
  result.first_frame = 0.0;
  result.particle_frames = 151;
  result.species = {"A", "long-name"};
  result.velocities = {{10, 0.0125, 0.0005}, {1, -0.25, std::nullopt}};
  result.granular_temperatures = {1.5e-4, std::nullopt};
  result.displacement_distributions = {{2.5, 1, -0.5, 0.25, {1, 3}}};
  result.drift = {{0.0, {10, 1}, {0.0, 0.0}}, {2.5, {6, 0}, {0.03, std::nullopt}}};
  result.bins = {{0.0, result.species, {{0, 0, 10}, {0, 0, 1}}, {}, {}, {}},
                 {2.5, result.species, {{1, 3, 6, 0.01, 0.03}, {1, 0, 0, 0.002, 0.0}}, 0.75, 0.5, -0.75}};
  BaseFrame base;
  base.time = 0.5;
  base.base.inclination = 0.125;
  base.base.commanded_inclination = 0.25;
  base.base.frequency = 23.0;
  base.base.commanded_frequency = 30.0;
  base.base.amplitude = 0.002;
  base.base.commanded_amplitude = 0.003;
  result.base = {base};
  StatisticsFrame statistics;
  statistics.time = 2.5;
  statistics.species = {{"A", {}, 0.25}, {"long-name", {}, std::nullopt}};
  statistics.species[0].means.mean_vx = 0.5;
  statistics.species[0].means.mean_vx_stderr = 0.02;
  statistics.species[0].means.collision_rate = 40.0;
  statistics.window_start = 2.25;
  statistics.window_end = 2.375;
  statistics.collisions = {100, 20, 40, 3, 0};
  statistics.collision_rates = {50.0, 5.0, 10.0, 0.5, 0.0};
  statistics.max_overlap = 1e-16;
  result.statistics = {statistics};
  const auto profile = [](const char* name, double value) {
    return ObservedColumn{name, "", {value, value}};
  };
  result.observed = {{"mass_flow",
                      {{"left",
                        "A",
                        {{"mean", "kg/s", 0.5}, {"stderr", "kg/s", std::nullopt}},
                        {{"time", "s", {1.5, 2.5}}, {"flow", "kg/s", {0.75, std::nullopt}}}}}},
                     {"height_profile",
                      {{"",
                        "long-name",
                        {{"mean_height", "m", 0.25}},
                        {profile("phase_from", 0.0), profile("from", 0.1), profile("to", 0.2),
                         profile("number_density", 4.0), profile("velocity_along", 0.1),
                         profile("velocity_up", -0.1), profile("temperature", 1e-6)}}}}};
  return result;
}

}  // namespace ratchet_sieve
