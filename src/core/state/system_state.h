#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/base_motion.h"
#include "model/base_shape.h"
#include "model/disk.h"
#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/sizes.h"
#include "ratchet_sieve/core/state_archive.h"
#include "ratchet_sieve/statistics/segregation.h"
#include "state/collapse_watch.h"
#include "state/disk_ids.h"
#include "state/disk_record.h"
#include "state/event_log.h"
#include "state/run_sums.h"

namespace ratchet_sieve
{

/// The run's zero of time, moved by whole epochs: times within an epoch are small, so that their resolution
/// after 10^6 s is the same as at the start. A power of two [s], so that no rounding occurs.
struct Epoch
{
  double start = 0.0;   ///< [s]
  double length = 1.0;  ///< [s]

  void archive(StateArchive& state) { state(start, length); }
};

/// The base, the disks, and what is kept of each disk: its count of events and the observers' sums. A disk is
/// in all of these or in none, at one *slot* of the arrays (DiskIds), and they have one common zero of time.
/// Times are local to the epoch.
class SystemState
{
public:
  explicit SystemState(const SceneDefinition& scene);
  SystemState(const SystemState&) = delete;
  SystemState& operator=(const SystemState&) = delete;

  const SceneDefinition& scene() const { return scene_; }
  const Plan& plan() const { return plan_; }
  const BaseShape& shape() const { return shape_; }
  const BaseMotion& motion() const { return motion_; }

  /// Calls `command` with the base's motion and the time; it changes the motion at that time. Disks keep
  /// position and velocity; on a periodic base the stored image of a disk may change.
  template <typename Command>
  void changeMotion(Command&& command, double time)
  {
    const bool turned = motion_.turning();
    log_.endSegment(time);
    command(motion_, time);
    if (motion_.turning() && !turned)
      wrapAll(time);
  }
  const Epoch& epoch() const { return epoch_; }

  /// See ratchet_sieve::timeScale().
  double timeScale() const { return time_scale_; }
  double largestDiameter() const { return largest_diameter_; }

  /// While a periodic base turns: the largest angle between the inclination and that in the middle of a
  /// segment of the motion [rad]; and how far an image at the other end then moves along the base [m], or in
  /// any direction if sizes are wide.
  double latticeTurn() const { return lattice_turn_; }
  double latticeMargin() const;

  /// Whether the scene's sizes are wide; see areWide().
  bool wideSizes() const { return lattice_diameter_ < largest_diameter_; }
  double smallestRadius() const;

  /// Of the disks in the machine, in the order of their slots [m].
  std::vector<double> activeRadii() const;
  const Sizes& sizes(std::size_t species) const { return sizes_[species]; }
  const std::vector<SizeClass>& sizeClasses() const { return size_classes_; }

  /// The class of a disk; the number of classes if its species has no sizes.
  std::size_t sizeClassOf(const Disk& disk) const;

  const SlotArray<Disk>& disks() const { return disks_; }
  const Disk& disk(std::uint32_t slot) const { return disks_[slot]; }
  double radius(std::uint32_t slot) const { return disks_[slot].radius; }
  const DiskRecord& record(std::uint32_t slot) const { return records_[slot]; }
  DiskRecord& record(std::uint32_t slot) { return records_[slot]; }
  const DiskProperties& properties(std::uint32_t slot) const { return records_[slot].properties; }
  bool active(std::uint32_t slot) const { return records_[slot].active; }
  std::size_t activeCount() const { return active_count_; }
  std::uint32_t id(std::uint32_t slot) const { return ids_.of(slot); }
  const CollapseWatch& collapseWatch() const { return collapse_watch_; }
  CollapseWatch& collapseWatch() { return collapse_watch_; }
  const RunSums& sums() const { return sums_; }
  RunSums& sums() { return sums_; }
  const EventLog& log() const { return log_; }
  EventLog& log() { return log_; }

  /// Prefetches the memory of an event of this disk.
  void prefetchEvent(std::uint32_t slot) const
  {
    prefetch(disks_[slot]);
    prefetch(records_[slot]);
  }

  /// The whole widths by which a position s along a periodic base is outside of [0, W); 0 for other bases.
  double widthsOutside(double s) const
  {
    return scene_.boundary == Boundary::PERIODIC ? wholeWidths(s, 1.0 / shape_.width()) : 0.0;
  }

  Kinematics flown(std::uint32_t slot, double time) const
  {
    return kinematicsAt(disks_[slot], time, scene_.gravity);
  }

  /// The image `shift` widths to the right, relative to the disk itself, at `time`.
  Image image(double shift, double time) const
  {
    return shift == 0.0 ? Image() : motion_.at(time).image(shift * shape_.width());
  }

  /// Allocates memory for this number of disks.
  void reserve(std::size_t count);

  /// Adds a disk that is at its position, with its velocity, at `time`. @return its slot, after all others
  std::uint32_t add(Disk disk, const DiskProperties& properties, double time);

  /// What changes a flight.
  struct Turn
  {
    Two way{};          ///< by which the disk is moved [m]
    Two velocity{};     ///< is added [m/s]
    double spin = 0.0;  ///< is added [rad/s]
  };

  /// Takes an executed contact. @param buffer of the thread, if several advance disks at the same time
  void collided(const ContactOutcome& outcome, ThreadBuffer* buffer = nullptr)
  {
    if (buffer != nullptr)
      return buffer->collided(outcome);
    sums_.contacts.add(outcome);
    if (outcome.closed)
      log_.collided(outcome);
  }

  /// Changes a disk's flight at `time`. @param buffer as in collided(), here and below
  [[gnu::always_inline]] void redirect(std::uint32_t slot, const Turn& turn, double time,
                                       ThreadBuffer* buffer = nullptr)
  {
    Disk& disk = disks_[slot];
    log_.flew(slot, disk, time, buffer);
    const Two velocity = twoOf(disk.velocity);
    const double spin = disk.spin;
    disk.redirect(turn.way, turn.velocity, time);
    disk.spin += turn.spin;
    records_[slot].turn(velocity, spin, disk, time, scene_.gravity);
  }

  /// For SIMD batches. May be called by several threads for different disks at the same time.
  Disk& changeable(std::uint32_t slot) { return disks_[slot]; }

  /// Moves the disk to its image `shift` widths to the right, on the same flight.
  void wrap(std::uint32_t slot, double shift, double time, ThreadBuffer* buffer = nullptr)
  {
    moveTo(slot, image(shift, time), time, buffer);
  }

  /// Wraps a disk on a periodic base by the number of widths that brings `s`, its position along the base,
  /// into [0, W). Does nothing while the base turns, because a disk is then wrapped only when it passes an
  /// end.
  void wrapIntoWidth(std::uint32_t slot, double s, double time, ThreadBuffer* buffer = nullptr);

  /// The disk passes an end of the base: into the bin, or on a periodic base to its image at the other end.
  void passEnd(std::uint32_t slot, bool to_the_right, double time, ThreadBuffer* buffer = nullptr);

  /// Takes what a thread has observed. Observers are told of it by EventLog::deliver().
  void merge(ThreadBuffer&& buffer);

  /// What events without a collapse change of the disks, until their ThreadBuffer is merged.
  struct Snapshot
  {
    SlotArray<Disk> disks;
    SlotArray<DiskRecord> records;
  };
  void copyTo(Snapshot& snapshot) const
  {
    snapshot.disks = disks_;
    snapshot.records = records_;
  }
  void restore(const Snapshot& snapshot)
  {
    disks_ = snapshot.disks;
    records_ = snapshot.records;
  }

  /// What events change of a disk that collides with no other, until their ThreadBuffer is merged.
  struct DiskCopy
  {
    Disk disk;
    DiskRecord record;
  };
  DiskCopy copyOf(std::uint32_t slot) const { return {disks_[slot], records_[slot]}; }
  void restore(std::uint32_t slot, const DiskCopy& copy)
  {
    disks_[slot] = copy.disk;
    records_[slot] = copy.record;
  }

  /// The slots of the active disks, or of the others, in increasing order.
  std::vector<std::uint32_t> slots(bool active) const;

  /// Disks that have left are closed in the averages, so that these cost what is in the machine.
  void closePaths();

  /// Removes disks that have left from the arrays if they are the majority; the others move to smaller slots.
  /// @return whether it did
  bool compact();

  /// The end of `settle`: the means begin anew.
  void restart(double time);

  /// The impulse that the base gave to the disks since the means began, world frame [N s].
  Eigen::Vector2d baseImpulse() const;

  /// Time counts from `start` [s] instead of 0. @pre nothing has happened yet
  /// @return the start, local to the epoch: epochs are multiples of their length from time 0, so that times
  /// are exact
  double startAt(double start);

  /// Shortens the epoch if a command made the drive too fast for its time resolution. Then the zero of time
  /// must be moved to the epoch that contains `now`: call rebase().
  /// @return the distance by which it must be moved [s], a multiple of the new length; 0 if nothing changes
  double shortenEpoch(double now);

  /// Moves the zero of time by `length`, a multiple of the epoch. @pre no disk's next event is before it
  void rebase(double length);

  /// @throws StateError as StateArchive, or if the state is of another number of species
  void archive(StateArchive& state);

private:
  void wrapAll(double time);
  void moveTo(std::uint32_t slot, const Image& image, double time, ThreadBuffer* buffer);

  SceneDefinition scene_;
  std::vector<Sizes> sizes_;  ///< per species
  std::vector<SizeClass> size_classes_;
  Plan plan_;
  BaseShape shape_;
  double largest_diameter_;
  double lattice_diameter_;  ///< the largest, or the root mean square of the scene's if sizes are wide
  double lattice_turn_;
  double time_scale_;
  Epoch epoch_;
  BaseMotion motion_;

  SlotArray<Disk> disks_;
  SlotArray<DiskRecord> records_;  ///< by slot, as the disks
  Eigen::Vector2d impulse_of_gone_ =
      Eigen::Vector2d::Zero();  ///< of the base to disks removed by compaction [N s]
  std::size_t active_count_ = 0;
  DiskIds ids_;
  CollapseWatch collapse_watch_;
  RunSums sums_;
  EventLog log_;
};

}  // namespace ratchet_sieve
