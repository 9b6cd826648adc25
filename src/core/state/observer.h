#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "model/base_shape.h"
#include "model/disk.h"
#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/luding_law.h"
#include "ratchet_sieve/core/observation.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Keeps only the elements at these slots of an array, which become consecutive. @param slots in increasing
/// order
template <typename T>
void keepSlots(std::vector<T>& array, const std::vector<std::uint32_t>& slots)
{
  for (std::size_t k = 0; k < slots.size(); ++k)
    array[k] = array[slots[k]];
  array.resize(slots.size());
}

/// The ids of the disks. A disk's *id* is its public number: every new disk gets the next. Its *slot* is its
/// index in the arrays. Both are equal until disks that have left are removed by compaction, which moves the
/// others to smaller slots.
class DiskIds
{
public:
  std::uint32_t of(std::uint32_t slot) const { return compacted_ ? ids_[slot] : slot; }

  void added()
  {
    if (compacted_)
      ids_.push_back(next_);
    ++next_;
  }

  /// Keeps the disks at these slots, which become consecutive, and forgets the others.
  void keep(const std::vector<std::uint32_t>& slots)
  {
    std::vector<std::uint32_t> kept;
    kept.reserve(slots.size());
    for (const std::uint32_t slot : slots)
      kept.push_back(of(slot));
    ids_ = std::move(kept);
    compacted_ = true;
  }

  void archive(StateArchive& state) { state(compacted_, next_, ids_); }

  /// Whether it can belong to this number of slots.
  bool fits(std::size_t slots) const { return compacted_ ? ids_.size() == slots : next_ == slots; }

private:
  bool compacted_ = false;
  std::uint32_t next_ = 0;
  std::vector<std::uint32_t> ids_;  ///< by slot, once compacted
};

/// The outcome of an executed contact, for all observers.
struct ContactOutcome
{
  /// Value of j for the base.
  static constexpr std::uint32_t BASE = UINT32_MAX;

  double time = 0.0;  ///< local to the epoch [s]
  CollisionKind kind = CollisionKind::APEX;
  BaseFeature feature;                ///< of the base; none between two disks, and from SIMD batches
  std::uint32_t i = 0;                ///< slot of the disk
  std::uint32_t j = BASE;             ///< slot of the second disk
  std::uint32_t species = 0;          ///< of disk i
  std::uint32_t partner_species = 0;  ///< of disk j
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< unit normal from j to i, world frame
  double normal_velocity = 0.0;     ///< of the surfaces, < 0: approaching; 0 if they separate [m/s]
  double normal_impulse = 0.0;      ///< J_n >= 0, along the normal on i [N s]
  double tangential_impulse = 0.0;  ///< J_t, along the tangent (normal turned by +90 deg) on i [N s]
  double overlap = 0.0;             ///< at the contact, < 0 for a remaining gap [m]
  bool closed = false;              ///< whether the surfaces approached; otherwise nothing was changed
  bool lossless = false;            ///< whether it was lossless: within t_c, or because of a collapse
};

/// The impulse on disk i, world frame [N s].
inline Eigen::Vector2d impulseOf(const ContactOutcome& outcome)
{
  const auto push = pushOf<double>({outcome.normal_impulse, outcome.tangential_impulse}, outcome.normal.x(),
                                   outcome.normal.y());
  return {push.x, push.y};
}

/// A disk's flight, which ends or changes. Its last one ended where it began, or the disk entered then. Times
/// are local to the epoch.
struct Flight
{
  std::uint32_t slot;
  const Disk& disk;  ///< as it flew
  double end;        ///< [s]
};

/// A disk has left the system. Its last flight was observed before.
struct Departure
{
  std::uint32_t slot;
  std::uint32_t species;
  double mass;  ///< [kg]
  Exit exit;
  double time;  ///< local to the epoch [s]
};

/// The slots of a compaction, in increasing order.
struct Compaction
{
  std::vector<std::uint32_t> kept;  ///< these become consecutive
  std::vector<std::uint32_t> gone;  ///< of disks that have left
};

/// Observes what happens to the disks of a run, and changes none of it. A hook that is not overridden does
/// nothing. Times are local to the epoch. The system that an observer is given outlives it.
///
/// Observers of every run are members of Observers, which calls them without a virtual call. Others are
/// added for a scene or a caller that asks for them (Observers::add()), and cost nothing to those that do
/// not.
class Observer
{
public:
  /// What the added observers are told of only where one of them subscribes to it. All are told of
  /// departures.
  enum Subscription : unsigned
  {
    CONTACTS = 1,
    FLIGHTS = 2,
    BLOCKS = 4  ///< of the mean series
  };

  Observer() = default;
  Observer(const Observer&) = default;
  Observer& operator=(const Observer&) = default;
  virtual ~Observer() = default;

  virtual unsigned subscriptions() const { return 0; }

  /// A contact of approaching surfaces, after its execution.
  virtual void collided(const ContactOutcome& /*outcome*/) {}

  /// A flight, before the disk's is replaced by the next.
  virtual void flew(const Flight& /*flight*/) {}
  virtual void left(const Departure& /*departure*/) {}

  /// Memory for this number of disks is useful.
  virtual void reserve(std::size_t /*count*/) {}

  /// A disk is about to be added at the next slot.
  virtual void entered(const Disk& /*disk*/, double /*time*/) {}

  /// The disks of these slots are about to get other slots, or none.
  virtual void compact(const Compaction& /*compaction*/) {}

  /// The end of `settle`: the means begin anew.
  virtual void restart(double /*time*/) {}

  /// A block of the mean series ends.
  virtual void endBlock(double /*time*/) {}
  virtual void endEpoch(double /*time*/) {}

  /// A segment of the base's motion ends. An observer of the motion takes into account now what disks in
  /// flight did until then, because afterwards the motion before `time` is not known.
  virtual void endSegment(double /*time*/) {}

  /// The zero of time is about to be moved forward by `length`.
  virtual void rebase(double /*length*/) {}

  /// @throws StateError
  virtual void archive(StateArchive& /*state*/) {}

  /// Whether a restored state can be of this number of slots.
  virtual bool fits(std::size_t /*slots*/) const { return true; }
};

class SystemState;

/// An observer that a scene asks for by its name.
class Observable : public Observer
{
public:
  /// What was seen until `time`, local to the epoch.
  virtual Observed observed(double time) const = 0;
};

/// @param name of observableNames() @param system outlives it
/// @throws std::invalid_argument for another name
std::unique_ptr<Observable> makeObservable(const std::string& name, const SystemState& system);

constexpr const char* HEIGHT_PROFILE = "height_profile";
std::unique_ptr<Observable> makeHeightProfile(const SystemState& system);

}  // namespace ratchet_sieve
