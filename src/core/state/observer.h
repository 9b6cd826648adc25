#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/disk.h"
#include "ratchet_sieve/core/state_archive.h"
#include "state/contact_outcome.h"

namespace ratchet_sieve
{

/// A disk's free flight from one stored state to the next. Times are local to the epoch.
struct Flight
{
  std::uint32_t slot;
  const Disk& from;  ///< the state at its start
  double end;        ///< [s]
};

/// Where a disk went.
enum class Exit : std::uint8_t
{
  LEFT_BIN,
  RIGHT_BIN
};

/// A disk has left the system. Its last flight was observed before.
struct Departure
{
  std::uint32_t slot;
  std::uint32_t species;
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
/// nothing. Times are local to the epoch.
///
/// Observers of every run are members of Observers, which calls them without a virtual call. Others are
/// added for a scene or a caller that asks for them (Observers::add()), and cost nothing to those that do
/// not.
class Observer
{
public:
  /// What an added observer is told of; nobody is told of anything else.
  struct Wishes
  {
    bool contacts = false;
    bool flights = false;
    bool departures = false;
    bool blocks = false;  ///< of the mean series
  };

  Observer() = default;
  Observer(const Observer&) = default;
  Observer& operator=(const Observer&) = default;
  virtual ~Observer() = default;

  virtual Wishes wishes() const { return {}; }

  /// A contact of approaching surfaces, after its execution.
  virtual void take(const ContactOutcome& /*outcome*/) {}

  /// A flight, before the disk's state is replaced by that at its end.
  virtual void flew(const Flight& /*flight*/) {}
  virtual void left(const Departure& /*departure*/) {}

  /// Memory for this number of disks is useful.
  virtual void reserve(std::size_t /*count*/) {}

  /// A disk is about to be added at the next slot.
  virtual void entered(const Disk& /*disk*/) {}

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

}  // namespace ratchet_sieve
