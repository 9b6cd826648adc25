#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "bench.h"
#include "ratchet_sieve/core/simulation.h"
#include "state/contact_prediction.h"
#include "state/placement.h"

namespace ratchet_sieve::test
{

/// Of the base to an inclination [rad], from time 0 on.
struct Turn
{
  double rate = 0.0;  ///< 0: it stays [rad/s]
  double inclination = 0.0;

  SlewRates slewRates() const { return {rate, 10.0, 0.002}; }
};

inline void turnBase(SystemState& system, const Turn& turn)
{
  system.changeMotion(
      [=](BaseMotion& motion, double now)
      {
        motion.setSlewRates(turn.slewRates(), now);
        motion.command(Quantity::INCLINATION, turn.inclination, now);
      },
      0.0);
}

/// The slow reference: before every event it tests every pair with all images, and every disk against the
/// base; no queue, no cells, no stored predictions. It follows a base that moves to its setpoints.
class ReferenceLoop
{
public:
  /// @param images number of images of a disk on a ring that are tested on either side
  explicit ReferenceLoop(Bench& bench, int images = 3)
      : state_(bench.state), execution_(bench.execution), images_(images)
  {
  }

  void advanceTo(double end)
  {
    while (const auto change = state_.motion().nextChange())
    {
      if (*change > end)
        break;
      advanceWithinSegment(*change);
      now_ = *change;
      state_.changeMotion([](BaseMotion& motion, double now) { motion.beginSegment(now); }, now_);
    }
    advanceWithinSegment(end);
  }

private:
  struct Event
  {
    double time;
    std::uint32_t i, j;
    int shift;
    BaseFeature feature;
  };

  void advanceWithinSegment(double end)
  {
    while (const auto next = earliest(end))
    {
      now_ = next->time;
      if (next->feature)
      {
        BaseInstant base(state_.motion());
        execution_.handleBaseEvent(next->i, next->feature, now_, base);
      }
      else
        execution_.collidePair(next->i, next->j, next->shift, now_);
    }
  }

  std::optional<Event> earliest(double end) const
  {
    std::optional<Event> best;
    const auto take = [&](const Event& event)
    {
      if (event.time <= end && (!best || event.time < best->time))
        best = event;
    };
    ContactPrediction prediction(state_);
    const int images = state_.scene().boundary == Boundary::PERIODIC ? images_ : 0;
    for (std::uint32_t i = 0; i < state_.disks().size(); ++i)
    {
      if (!state_.active(i))
        continue;
      BaseEvent base{now_, {}};
      while (!base.feature && base.time < end)
        base = prediction.nextBaseEvent(i, state_.flown(i, base.time), end);
      if (base.feature)
        take({base.time, i, i, 0, base.feature});
      for (std::uint32_t j = 0; j < i; ++j)
        for (int shift = -images; shift <= images && state_.active(j); ++shift)
          if (const auto time = prediction.pairsOf(i, now_).contactWith(j, shift))
            take({*time, i, j, shift, {}});
    }
    return best;
  }

  SystemState& state_;
  ContactExecution& execution_;
  int images_;
  double now_ = 0.0;
};

/// A scene run by the reference until `end` [s], with the disks that it places and pours.
inline void runReference(const SceneDefinition& scene, double end, const CollisionObserver& observer,
                         const Turn& turn = {}, int images = 3)
{
  Bench bench(scene);
  bench.state.log().observeCollisions(observer);
  placeInitialDisks(bench.state, 0.0);
  Random random(scene.seed);
  pourDisks(bench.state, pourOrder(scene.species, random), Stretch(), 0.0, random);
  if (turn.rate > 0.0)
    turnBase(bench.state, turn);
  ReferenceLoop(bench, images).advanceTo(end);
}

/// The same run with other roundings: the same contacts of the same disks, at nearly the same times.
/// @param tolerance [s]
inline void expectSameContacts(const std::vector<CollisionRecord>& fast,
                               const std::vector<CollisionRecord>& slow, double tolerance)
{
  ASSERT_EQ(fast.size(), slow.size());
  const auto disks = [](const CollisionRecord& r)
  { return std::make_pair(std::min(r.i, r.j.value_or(r.i)), std::max(r.i, r.j.value_or(r.i))); };
  for (std::size_t k = 0; k < fast.size(); ++k)
  {
    ASSERT_NEAR(fast[k].time, slow[k].time, tolerance) << "collision " << k;
    ASSERT_EQ(fast[k].kind, slow[k].kind) << "collision " << k;
    ASSERT_EQ(disks(fast[k]), disks(slow[k])) << "collision " << k;
  }
}

}  // namespace ratchet_sieve::test
