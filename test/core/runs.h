#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"

/// What tests look at in a run.
namespace ratchet_sieve::test
{

/// The collisions from now until `end` [s].
inline std::vector<CollisionRecord> collisionsUntil(Simulation& simulation, double end)
{
  std::vector<CollisionRecord> records;
  simulation.observeCollisions([&](const CollisionRecord& record) { records.push_back(record); });
  simulation.advanceTo(end);
  simulation.observeCollisions({});
  return records;
}

inline std::vector<CollisionRecord> collisionsUntil(const SceneDefinition& scene, double end)
{
  Simulation simulation(scene);
  return collisionsUntil(simulation, end);
}

/// To the last bit.
inline bool areSame(const CollisionRecord& a, const CollisionRecord& b)
{
  return a.time == b.time && a.kind == b.kind && a.i == b.i && a.j == b.j &&
         a.normal_speed == b.normal_speed && a.normal_impulse == b.normal_impulse &&
         a.tangential_impulse == b.tangential_impulse;
}

/// @param largest overlap so far [m]
inline void expectNoOverlap(Simulation& simulation, double largest = 1e-12)
{
  EXPECT_EQ(simulation.auditOverlaps(), 0u) << "at " << simulation.time() << " s";
  EXPECT_LT(simulation.maxOverlap(), largest) << "at " << simulation.time() << " s";
}

}  // namespace ratchet_sieve::test
