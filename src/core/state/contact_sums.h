#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/disk_events.h"

namespace ratchet_sieve
{

/// Counts of contacts since the start of the run.
struct ContactCounts
{
  CollisionCounts collisions;
  double max_overlap = 0.0;      ///< [m]
  std::uint64_t pushed_out = 0;  ///< how often a disk was found below the base's surface and moved out

  void addOverlap(double overlap) { max_overlap = overlap > max_overlap ? overlap : max_overlap; }

  void archive(StateArchive& state) { state(collisions, max_overlap, pushed_out); }
};

/// Sums over contacts, independent of their order.
struct ContactSums
{
  ContactCounts counts;
  std::vector<std::uint64_t> of_species;  ///< since the means began; a contact counts for each disk of it

  explicit ContactSums(std::size_t species) : of_species(species) {}

  void add(const ContactOutcome& outcome) { add(outcome, counts); }

  /// Of contacts: `outcome(k)` for k < count.
  template <typename OutcomeAt>
  void add(std::size_t count, OutcomeAt&& outcome_at)
  {
    // A local copy stays in registers, because the compiler must assume that it may alias the outcomes.
    ContactCounts local = counts;
    for (std::size_t k = 0; k < count; ++k)
      add(outcome_at(k), local);
    counts = local;
  }

  void add(const ContactSums& more)
  {
    counts.addOverlap(more.counts.max_overlap);
    counts.pushed_out += more.counts.pushed_out;
    counts.collisions.add(more.counts.collisions);
    for (std::size_t species = 0; species < of_species.size(); ++species)
      of_species[species] += more.of_species[species];
  }

  void restart() { std::fill(of_species.begin(), of_species.end(), 0); }
  void archive(StateArchive& state) { state(counts, of_species); }

private:
  void add(const ContactOutcome& outcome, ContactCounts& to)
  {
    to.addOverlap(outcome.overlap);
    if (!outcome.closed)
      return;
    to.collisions.add(outcome.kind);
    ++of_species[outcome.species];
    if (outcome.j != ContactOutcome::BASE)
      ++of_species[outcome.partner_species];
  }
};

}  // namespace ratchet_sieve
