#pragma once

#include <cstdint>

#include "state/contact_outcome.h"

namespace ratchet_sieve
{

/// Counts of contacts, independent of their order.
struct ContactCounts
{
  CollisionCounts collisions;    ///< of contacts with approaching surfaces
  double max_overlap = 0.0;      ///< [m]
  std::uint64_t pushed_out = 0;  ///< how often a disk was found below the base's surface and moved out

  void take(const ContactOutcome& outcome)
  {
    takeOverlap(outcome.overlap);
    collisions.add(outcome.kind, outcome.closed ? 1 : 0);
  }

  void takeOverlap(double overlap) { max_overlap = overlap > max_overlap ? overlap : max_overlap; }

  void add(const ContactCounts& more)
  {
    takeOverlap(more.max_overlap);
    pushed_out += more.pushed_out;
    collisions.add(more.collisions);
  }

  void archive(StateArchive& state) { state(collisions, max_overlap, pushed_out); }
};

}  // namespace ratchet_sieve
