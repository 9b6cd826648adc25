#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "bench.h"
#include "search/pair_search.h"

namespace ratchet_sieve::test
{

/// Turns the base to an inclination [rad], at `rate` [rad/s], from `time` [s] on.
inline void turn(SystemState& system, double rate, double inclination, double time)
{
  system.changeMotion(
      [=](BaseMotion& motion, double now)
      {
        motion.setSlewRates({rate, 10.0, 0.002}, now);
        motion.command(Quantity::INCLINATION, inclination, now);
      },
      time);
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
    const int images = state_.scene().boundary == Boundary::PERIODIC ? images_ : 0;
    for (std::uint32_t i = 0; i < state_.disks().size(); ++i)
    {
      if (!state_.active(i))
        continue;
      BaseEvent base{std::max(now_, state_.disk(i).time), {}};
      while (!base.feature && base.time < end)
        base = state_.search().find(state_.disk(i), state_.radius(i), base.time, end);
      if (base.feature)
        take({base.time, i, i, 0, base.feature});
      for (std::uint32_t j = 0; j < i; ++j)
        for (int shift = -images; shift <= images && state_.active(j); ++shift)
          if (const auto time = PairSearch(state_.pairScene(), i, now_).contactWith(j, shift))
            take({*time, i, j, shift, {}});
    }
    return best;
  }

  SystemState& state_;
  ContactExecution& execution_;
  int images_;
  double now_ = 0.0;
};

}  // namespace ratchet_sieve::test
