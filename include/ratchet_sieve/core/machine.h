#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/base_motion.h"
#include "ratchet_sieve/core/collapse_watch.h"
#include "ratchet_sieve/core/collision_law.h"
#include "ratchet_sieve/core/contact_search.h"
#include "ratchet_sieve/core/disk.h"
#include "ratchet_sieve/core/disk_numbers.h"
#include "ratchet_sieve/core/observation.h"
#include "ratchet_sieve/core/plan.h"
#include "ratchet_sieve/core/sawtooth.h"
#include "ratchet_sieve/core/segregation.h"
#include "ratchet_sieve/core/tally.h"

namespace ratchet_sieve
{

/// The run's time zero, moved on by whole epochs: times within an epoch are small, so that a double
/// holds them as finely after 10^6 s as at the start. A power of two [s], so that nothing rounds.
struct Epoch
{
  double start = 0.0;   ///< [s]
  double length = 1.0;  ///< [s]

  void archive(StateArchive& state) { state(start, length); }
};

/// The machine and the disks in it: what an event does, not when. Times are local to the epoch.
class Machine
{
public:
  /// While a periodic base turns, its lattice turns against whatever stands still by no more than
  /// this share of the largest diameter before the motion begins a new segment.
  static constexpr double LATTICE_MARGIN = 0.45;

  explicit Machine(const SceneDefinition& scene) : Machine(scene, planOf(scene)) {}

  /// @throws std::invalid_argument unless the plan covers the scene
  Machine(const SceneDefinition& scene, const Plan& plan);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const SceneDefinition& scene() const { return scene_; }
  const Plan& plan() const { return plan_; }
  const Sawtooth& sawtooth() const { return sawtooth_; }
  const BaseMotion& motion() const { return motion_; }
  BaseMotion& motion() { return motion_; }
  const ContactSearch& search() const { return search_; }
  /// Time counts from `start` [s], not from 0. @pre nothing has happened yet
  /// @return the start, local to the epoch: epochs stand where they would, had it all begun at 0, so that
  /// times since their start are exact
  double startAt(double start);

  const Epoch& epoch() const { return epoch_; }

  /// Shortens the epoch where the drive has been commanded to be too fast for the times in it: a run that
  /// starts without it is not laid out for it. Then the zero of time has to move on to the epoch that `now`
  /// lies in: rebase().
  /// @return by how much it has to [s], a multiple of the new length; 0 where nothing changes
  double shortenEpoch(double now);

  /// See ratchet_sieve::timeScale().
  double timeScale() const { return time_scale_; }
  double largestDiameter() const { return largest_diameter_; }
  double smallestRadius() const;

  const std::vector<Disk>& disks() const { return disks_; }
  const Disk& disk(std::uint32_t id) const { return disks_[id]; }
  double radius(std::uint32_t id) const { return radii_[disks_[id].species]; }
  bool active(std::uint32_t id) const { return active_[id] != 0; }
  std::size_t activeCount() const { return active_count_; }

  /// Fetches what an event of this disk reads and writes here.
  void prefetchEvent(std::uint32_t id) const
  {
    prefetch(disks_[id]);
    collapse_watch_.prefetchWindow(id);
    tally_.prefetchPassage(id);
  }

  const CollapseWatch& collapseWatch() const { return collapse_watch_; }
  CollapseWatch& collapseWatch() { return collapse_watch_; }

  /// What the disk's flight meets of the base first, searched from `from` and no further than needed
  /// to know of all before `until`. Nothing for ever, if it meets nothing before the base's motion
  /// changes: then all is searched anew.
  BaseEvent nextBaseEvent(std::uint32_t id, double from, double until, BaseInstant& base) const;

  /// Where the image `shift` widths to the right appears at `time`, relative to the disk itself.
  Image image(double shift, double time) const
  {
    return shift == 0.0 ? Image() : motion_.at(time).image(shift * sawtooth_.width());
  }

  /// Makes room for so many disks: nothing but memory.
  void reserve(std::size_t count);

  /// Whether most places are those of disks that have left, and worth giving up.
  bool mostlyLeft() const;

  /// Gives up the places of disks that have left: those of the others, their ids, move up.
  void giveUpPlaces();

  /// By what a disk is known outside, wherever it stands.
  std::uint32_t number(std::uint32_t id) const { return numbers_.of(id); }

  /// Puts a disk in; its id is the place behind all others.
  std::uint32_t add(const Disk& disk);

  /// A disk meets the base, or passes its end and leaves. A contact that opens is left alone.
  void meetBase(std::uint32_t id, const BaseFeature& feature, double time, BaseInstant& base);

  /// Disk i meets the image of disk j that lies `shift` widths to the right of j.
  void meetPair(std::uint32_t i, std::uint32_t j, int shift, double time);

  /// Takes the disk to its image `shift` widths to the right, on the same flight.
  void wrap(std::uint32_t id, double shift, double time);

  /// Wraps a disk on a periodic base by as many widths as bring `s`, its place along the base, into [0, W).
  void bringHome(std::uint32_t id, double s, double time);

  /// Takes a disk out where it is, into no bin: it is in the machine still, but has no course to follow.
  void takeOut(std::uint32_t id, double time);

  /// Zero of time moves on by `length`, a multiple of the epoch's. @pre no disk's next event is before it
  void rebase(double length);
  void restartMeans(double time);
  void endPieceOfMeans(double time);

  std::vector<SpeciesBins> bins() const;
  std::vector<SpeciesMeans> means(double time) const;
  double displacement(std::uint32_t id, double x) const { return tally_.displacement(id, x); }
  const CollisionCounts& collisions() const { return collisions_; }
  double baseImpulseX() const { return tally_.impulseX(); }
  double baseImpulseY() const { return tally_.impulseY(); }
  double maxOverlap() const { return max_overlap_; }
  void noteOverlap(double overlap) { max_overlap_ = overlap > max_overlap_ ? overlap : max_overlap_; }
  void observeCollisions(CollisionObserver observer) { observer_ = std::move(observer); }

  /// For a loop that flies disks and executes contacts with the base by itself. Of different disks at the
  /// same time from several threads.
  Disk& ownDisk(std::uint32_t id) { return disks_[id]; }
  Tally& tally() { return tally_; }
  const Tally& tally() const { return tally_; }
  const ContactMasses& baseMasses(std::uint32_t species) const { return base_masses_[species]; }
  CollisionCounts& collisionCounts() { return collisions_; }
  const CollisionObserver& collisionObserver() const { return observer_; }

  /// @throws StateError as StateArchive, or if the state is of another number of species
  void archive(StateArchive& state);

private:
  /// The surfaces at a contact: unit normal on disk i, and relative velocity.
  struct Contact
  {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< in the world
    double normal_velocity = 0.0;
    double tangential_velocity = 0.0;  ///< only where there is spin
  };

  /// What a unit impulse changes.
  struct Response
  {
    double velocity;  ///< 1 / m [1/kg]
    double spin;      ///< r / I, of a tangential one [1/(kg m)]
  };

  Disk& fly(std::uint32_t id, double time);
  void leave(std::uint32_t id, bool to_the_right, double time);
  void endPassage(std::uint32_t id, double time);
  bool lossless(std::uint32_t id, double time) const;
  double reboundFloor(std::uint32_t id, bool no_loss) const;
  void touched(std::uint32_t id, double time);
  Impulse respond(const ContactCoefficients& coefficients, const ContactMasses& masses,
                  const Contact& contact, double floor) const;
  void push(std::uint32_t id, const Disk& now, const Contact& contact, const Impulse& impulse, double sign);
  void report(double time, CollisionKind kind, std::uint32_t i, const std::uint32_t* j,
              const Contact& contact, const Impulse& impulse);

  SceneDefinition scene_;
  Plan plan_;
  Sawtooth sawtooth_;
  double largest_diameter_;
  double time_scale_;
  double negligible_way_;  ///< [m]
  Epoch epoch_;
  BaseMotion motion_;
  ContactSearch search_;

  std::vector<double> radii_;                           ///< per species
  std::vector<ContactCoefficients> pair_coefficients_;  ///< per (species, species)
  std::vector<ContactMasses> pair_masses_;              ///< per (species, species)
  std::vector<ContactMasses> base_masses_;              ///< per species
  std::vector<Response> responses_;                     ///< per species

  std::vector<Disk> disks_;
  std::vector<std::uint8_t> active_;
  std::vector<double> last_contacts_;  ///< per disk, only where the plan has contact times
  std::size_t active_count_ = 0;
  DiskNumbers numbers_;
  CollapseWatch collapse_watch_;
  std::vector<SpeciesBins> bins_;
  Tally tally_;
  CollisionCounts collisions_;
  double max_overlap_ = 0.0;
  CollisionObserver observer_;
};

}  // namespace ratchet_sieve
