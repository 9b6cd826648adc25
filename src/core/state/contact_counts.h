#pragma once

#include <cstddef>
#include <cstdint>

#include "state/observer.h"

namespace ratchet_sieve
{

/// Counts of contacts since the start of the run, independent of their order.
class ContactCounts final : public Observer
{
public:
  CollisionCounts collisions;
  double max_overlap = 0.0;      ///< [m]
  std::uint64_t pushed_out = 0;  ///< how often a disk was found below the base's surface and moved out

  void take(const ContactOutcome& outcome) override { collisions.add(outcome.kind); }
  void takeOverlap(double overlap) { max_overlap = overlap > max_overlap ? overlap : max_overlap; }

  void add(const ContactCounts& more)
  {
    takeOverlap(more.max_overlap);
    pushed_out += more.pushed_out;
    collisions.add(more.collisions);
  }

  void archive(StateArchive& state) override { state(collisions, max_overlap, pushed_out); }
};

}  // namespace ratchet_sieve
