#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/base_motion.h"
#include "model/disk.h"
#include "model/sawtooth.h"
#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/segregation.h"
#include "search/contact_search.h"
#include "search/pair_search.h"
#include "state/disk_ids.h"
#include "state/epoch.h"
#include "state/passages.h"

namespace ratchet_sieve
{

/// Where the base and the disks are and how they move. A disk stands at a *slot* of arrays; see DiskIds.
/// Times are local to the epoch.
class MachineState
{
public:
  /// While a periodic base turns, its lattice turns against whatever stands still by no more than
  /// this share of the largest diameter before the motion begins a new segment.
  static constexpr double LATTICE_MARGIN = 0.45;

  explicit MachineState(const SceneDefinition& scene) : MachineState(scene, planOf(scene)) {}

  /// @throws std::invalid_argument unless the plan covers the scene
  MachineState(const SceneDefinition& scene, const Plan& plan);
  MachineState(const MachineState&) = delete;
  MachineState& operator=(const MachineState&) = delete;

  const SceneDefinition& scene() const { return scene_; }
  const Plan& plan() const { return plan_; }
  const Sawtooth& sawtooth() const { return sawtooth_; }
  const BaseMotion& motion() const { return motion_; }
  BaseMotion& motion() { return motion_; }
  const ContactSearch& search() const { return search_; }
  const PairScene& pairScene() const { return pair_scene_; }
  const Epoch& epoch() const { return epoch_; }

  /// See ratchet_sieve::timeScale().
  double timeScale() const { return time_scale_; }
  double largestDiameter() const { return largest_diameter_; }
  double smallestRadius() const;

  const std::vector<Disk>& disks() const { return disks_; }
  const Disk& disk(std::uint32_t slot) const { return disks_[slot]; }
  double radius(std::uint32_t slot) const { return pair_scene_.radius(slot); }
  bool active(std::uint32_t slot) const { return active_[slot] != 0; }
  std::size_t activeCount() const { return active_count_; }
  const DiskIds& ids() const { return ids_; }
  std::uint32_t id(std::uint32_t slot) const { return ids_.of(slot); }
  const Passages& passages() const { return passages_; }
  const std::vector<SpeciesBins>& bins() const { return bins_; }

  void prefetchFlight(std::uint32_t slot) const
  {
    prefetch(disks_[slot]);
    passages_.prefetchPassage(slot);
  }

  /// The disk's first event with the base, searched from `from` and no further than needed to know of
  /// all before `until`. At infinity if there is none before the base's motion changes, for then
  /// everything is predicted again.
  BaseEvent nextBaseEvent(std::uint32_t slot, double from, double until, BaseInstant& base) const;

  /// Where the image `shift` widths to the right appears at `time`, relative to the disk itself.
  Image image(double shift, double time) const { return pair_scene_.image(shift, time); }

  /// Makes room for so many disks: nothing but memory.
  void reserve(std::size_t count);

  /// Puts a disk in. @return its slot, behind all others
  std::uint32_t add(const Disk& disk);

  /// Writes the disk down where its flight has come to.
  void moveTo(std::uint32_t slot, const Disk& now)
  {
    passages_.flew(slot, disks_[slot], now.time);
    disks_[slot] = now;
  }

  /// For what changes a flight, and for a batch that flies disks by itself. Of different disks at the same
  /// time from several threads.
  Disk& changeable(std::uint32_t slot) { return disks_[slot]; }
  Passages& passages() { return passages_; }

  /// Takes the disk to its image `shift` widths to the right, on the same flight.
  void wrap(std::uint32_t slot, double shift, double time);

  /// Wraps a disk on a periodic base by as many widths as bring `s`, its position along the base, into [0,
  /// W).
  void wrapIntoWidth(std::uint32_t slot, double s, double time);

  /// The disk passes an end of the base, into the bin there.
  void leave(std::uint32_t slot, bool to_the_right, double time);

  /// Takes a disk out where it is, into no bin: it is in the machine still, but has no course to follow.
  void remove(std::uint32_t slot, double time);

  /// The slots of disks that are still active, or that are not, rising.
  std::vector<std::uint32_t> slots(bool active) const;

  /// Removes disks that have left from the arrays: those of the others move up. @param kept slots(true)
  void compact(const std::vector<std::uint32_t>& kept);

  /// What is counted in passages begins now.
  void restartPassages(double time) { passages_.restart(disks_, active_, epoch_.start + time, time); }

  /// Time counts from `start` [s], not from 0. @pre nothing has happened yet
  /// @return the start, local to the epoch: epochs stand where they would, had it all begun at 0, so that
  /// times since their start are exact
  double startAt(double start);

  /// Shortens the epoch where the drive has been commanded to be too fast for the times in it: a run that
  /// starts without it has an epoch too long for it. Then the zero of time has to move on to the epoch that
  /// `now` lies in: rebase().
  /// @return by how much it has to [s], a multiple of the new length; 0 where nothing changes
  double shortenEpoch(double now);

  /// Zero of time moves on by `length`, a multiple of the epoch's. @pre no disk's next event is before it
  void rebase(double length);

  /// @throws StateError as StateArchive, or if the state is of another number of species
  void archive(StateArchive& state);

private:
  void setTimeResolution();
  Disk& fly(std::uint32_t slot, double time);
  void endPassage(std::uint32_t slot, double time);

  SceneDefinition scene_;
  Plan plan_;
  Sawtooth sawtooth_;
  double largest_diameter_;
  double time_scale_;
  Epoch epoch_;
  BaseMotion motion_;
  ContactSearch search_;
  std::vector<double> radii_;  ///< per species

  std::vector<Disk> disks_;
  std::vector<std::uint8_t> active_;
  std::size_t active_count_ = 0;
  DiskIds ids_;
  Passages passages_;
  std::vector<SpeciesBins> bins_;
  PairScene pair_scene_;  ///< of the members above
};

}  // namespace ratchet_sieve
