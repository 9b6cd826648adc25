#pragma once

#include <utility>
#include <vector>

#include "model/prefetch.h"
#include "ratchet_sieve/core/mean_series.h"
#include "ratchet_sieve/core/observation.h"
#include "state/accuracy_series.h"
#include "state/base_impulses.h"
#include "state/contact_counts.h"
#include "state/contact_times.h"
#include "state/species_averages.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// A contact as a record for callers.
CollisionRecord recordOf(const ContactOutcome& outcome, const SystemState& system);

/// The record of a run: the observers of its contacts, and the means.
class Observers
{
public:
  /// @param system outlives this
  explicit Observers(const SystemState& system);

  /// Takes an executed contact.
  void take(const ContactOutcome& outcome)
  {
    counts_.take(outcome);
    if (!outcome.closed)
      return;
    impulses_.take(outcome);
    times_.take(outcome);
    averages_.take(outcome, system_);
    if (observer_)
      observer_(recordOf(outcome, system_));
  }

  /// Takes counts of base contacts executed by SIMD; their impulses were added there.
  /// @param contacts per species
  void take(const ContactCounts& counts, const std::vector<std::uint64_t>& contacts)
  {
    counts_.add(counts);
    averages_.add(contacts);
  }

  void reserve(std::size_t count) { impulses_.reserve(count); }
  void prefetchSums(std::uint32_t slot) const { prefetch(impulses_.of(slot)); }
  void added();

  /// Keeps the disks at these slots of the machine; those at the others are about to be removed by
  /// compaction.
  void keep(const std::vector<std::uint32_t>& kept, const std::vector<std::uint32_t>& left);

  const ContactCounts& counts() const { return counts_; }
  ContactCounts& counts() { return counts_; }
  const ContactTimes& contactTimes() const { return times_; }
  const BaseImpulses& impulses() const { return impulses_; }
  BaseImpulses& impulses() { return impulses_; }
  const CollisionObserver& collisionObserver() const { return observer_; }
  void observeCollisions(CollisionObserver observer) { observer_ = std::move(observer); }

  void restartMeans();

  /// Whether the series of the means is recorded in blocks: always for a layer, whose disks move together.
  /// Independent disks need none, unless the scene requests an accuracy.
  bool keepsBlocks() const { return system_.plan().pairs || accuracy_.kept(); }
  void endBlockOfMeans(double time);

  /// @param block_time of the original blocks [s]
  MeanSeries meanSeries(double block_time) const;
  std::vector<SpeciesMeans> means(double time) const { return averages_.means(system_, time); }
  std::vector<SpeciesMeans> sizeClassMeans(double time) const
  {
    return averages_.sizeClassMeans(system_, time);
  }

  void rebase(double length) { times_.rebase(length); }

  /// @throws StateError if the state is not of the machine's disks, which must be restored before
  void archive(StateArchive& state);

private:
  const SystemState& system_;
  ContactCounts counts_;
  BaseImpulses impulses_;
  ContactTimes times_;
  SpeciesAverages averages_;
  AccuracySeries accuracy_;
  CollisionObserver observer_;
};

}  // namespace ratchet_sieve
