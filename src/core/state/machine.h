#pragma once

#include <cstdint>

#include "state/collapse_watch.h"
#include "state/contact_execution.h"
#include "state/observers.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// The machine's state together with the objects that act on it and record it. A disk is in all of them or in
/// none, and they have one common zero of time.
class Machine
{
public:
  explicit Machine(const SceneDefinition& scene) : Machine(scene, planOf(scene)) {}

  /// @throws std::invalid_argument unless the plan covers the scene
  Machine(const SceneDefinition& scene, const Plan& plan);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const SystemState& state() const { return state_; }
  SystemState& state() { return state_; }
  const CollapseWatch& collapseWatch() const { return collapse_watch_; }
  CollapseWatch& collapseWatch() { return collapse_watch_; }
  const Observers& record() const { return record_; }
  Observers& record() { return record_; }
  const ContactExecution& execution() const { return execution_; }

  /// Allocates memory for this number of disks.
  void reserve(std::size_t count);

  /// Adds a disk. @return its slot
  std::uint32_t add(const Disk& disk, const Grain& grain);

  /// Executes a disk's event with the base: a contact, or the trajectory of an end.
  void handleBaseEvent(std::uint32_t slot, const BaseFeature& feature, double time, BaseInstant& base)
  {
    if (feature.isEnd())
      return state_.passEnd(slot, feature.kind == BaseFeatureKind::RIGHT_END, time);
    record_.take(execution_.collideWithBase(slot, feature, time, base));
  }

  /// See ContactExecution::collidePair().
  void collidePair(std::uint32_t i, std::uint32_t j, int shift, double time)
  {
    record_.take(execution_.collidePair(i, j, shift, time));
  }

  /// Prefetches the memory of an event of this disk.
  void prefetchEvent(std::uint32_t slot) const
  {
    state_.prefetchFlight(slot);
    collapse_watch_.prefetchWindow(slot);
    record_.prefetchSums(slot);
  }

  /// Removes the disks that have left from the arrays if they are the majority.
  /// @return whether it did: slots have then changed
  bool compact();

  /// See SystemState.
  double startAt(double start);
  void rebase(double length);
  void restartMeans(double time);

  /// @throws StateError as StateArchive, or if the state is of another scene
  void archive(StateArchive& state);

private:
  SystemState state_;
  CollapseWatch collapse_watch_;
  Observers record_;
  ContactExecution execution_;
};

}  // namespace ratchet_sieve
