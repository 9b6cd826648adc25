#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"

/// The one scene that every program of the comparison runs: the mixture of Fig. 8 at theta = 0.
namespace ratchet_sieve::peers
{

/// Teeth beyond each end, for disks that have passed an end and are not yet moved.
constexpr int EXTRA_TEETH = 2;

struct BaseState
{
  double y = 0.0;   ///< Y [m]
  double vy = 0.0;  ///< dY/dt [m/s]
};

struct Point
{
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]
};

/// 20 teeth with 262 disks A (1 mm, 10 g) and 262 B (2 mm, 1 g), e = 0.6, mu = 0.1, periodic.
SceneDefinition mixtureScene(std::uint64_t seed);

/// The scene's coefficients, the same for every contact.
const ContactCoefficients& contactOf(const SceneDefinition& scene);

/// This project's pour at t = 0: at rest, without contacts.
std::vector<DiskState> startOf(const SceneDefinition& scene);

/// The base's outline at Y = 0: foot, apex, foot, ... from left to right, EXTRA_TEETH beyond either end.
std::vector<Point> outline(const BaseDefinition& base);

BaseState baseAt(const BaseDefinition& base, double time);

}  // namespace ratchet_sieve::peers
