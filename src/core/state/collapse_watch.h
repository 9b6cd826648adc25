#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/prefetch.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/observation.h"
#include "state/disk_ids.h"

namespace ratchet_sieve
{

/// Notices that time has all but stopped for a disk: it has more events within the machine's time
/// scale than the scene allows. That is an inelastic collapse (McNamara & Young, Phys. Fluids A 4,
/// 496 (1992), doi:10.1063/1.858323), or a disk that is wedged between bodies.
///
/// Where the scene says that the run goes on, the disk is lossless until it has gone through a whole
/// time scale without a collapse: its contacts lose no energy, which lets a wedged disk press its way
/// out, and part no slower than a floor, which lets a resting one hop. The floor doubles with every
/// collapse that follows another. A disk that even that does not free is stuck.
class CollapseWatch
{
public:
  /// @param time_scale of the machine [s]; @param speed_scale of a fall over a tooth [m/s]
  /// @param ids by which disks are named; outlives this
  CollapseWatch(const ContactDefinition& contact, double time_scale, double speed_scale, const DiskIds& ids);

  void reserve(std::size_t count) { disks_.reserve(count); }
  void added() { disks_.emplace_back(); }

  /// The disks at these slots stand one behind the other from now on, the others are gone.
  void keep(const std::vector<std::uint32_t>& slots);

  /// Counts an event of a disk. @return whether it is one too many; from then on the disk is lossless
  bool count(std::uint32_t slot, double time)
  {
    Window& window = disks_[slot];
    if (time >= window.end)
      open(window, time);
    if (++window.events <= limit_)
      return false;
    collapse(slot, time);
    return true;
  }

  /// Counts an event of a disk, unless it would be one too many or the disk is lossless: then nothing is
  /// done. Of different disks at the same time from several threads.
  /// @return whether it was counted
  bool countOrdinary(std::uint32_t slot, double time)
  {
    Window window = disks_[slot];
    if (lossless(slot))
      return false;
    if (time >= window.end)
      open(window, time);
    if (++window.events > limit_)
      return false;
    disks_[slot] = window;
    return true;
  }

  std::size_t disks() const { return disks_.size(); }
  void prefetchWindow(std::uint32_t slot) const { prefetch(disks_[slot]); }

  /// Whether the disk's contacts lose no energy for now. As long as none collapsed, without reading its
  /// state.
  bool lossless(std::uint32_t slot) const { return counts_.count > 0 && disks_[slot].level > 0; }

  /// How slowly a lossless disk's contacts may part [m/s].
  double floorSpeed(std::uint32_t slot) const;

  /// Whether even MAX_LEVEL collapses in a row, without loss, did not free the disk.
  bool stuck(std::uint32_t slot) const;

  /// Whether the run has to end: the scene says so, or a disk is stuck.
  bool stops() const { return stops_; }

  const CollapseCounts& counts() const { return counts_; }

  /// What happened, in one line with its numbers. @pre counts().count > 0
  std::string text() const;

  /// Zero of time moves on; @param epoch_start the new one [s]
  void rebase(double length, double epoch_start);

  void archive(StateArchive& state) { state(epoch_start_, disks_, counts_, first_stuck_, stops_); }

private:
  /// The events of one disk since its present window was opened.
  struct Window
  {
    double end = 0.0;  ///< local to the epoch [s]
    std::uint32_t events = 0;
    std::uint32_t level = 0;  ///< collapses in a row

    void archive(StateArchive& state) { state(end, events, level); }
  };

  /// A disk that collapses although its contacts lose nothing.
  struct Stuck
  {
    double time;  ///< of the run [s]
    std::uint32_t disk;

    void archive(StateArchive& state) { state(time, disk); }
  };

  /// Where a collapse ends the run, the disk stays lossless on the way there.
  void open(Window& window, double time) const
  {
    window = {time + time_scale_, 0, contact_.on_collapse == CollapseAction::STOP ? window.level : 0};
  }
  void collapse(std::uint32_t slot, double time);

  ContactDefinition contact_;
  const DiskIds& ids_;
  std::uint32_t limit_;
  double time_scale_;
  double speed_scale_;
  double epoch_start_ = 0.0;
  std::vector<Window> disks_;
  CollapseCounts counts_;
  std::optional<Stuck> first_stuck_;
  bool stops_ = false;
};

}  // namespace ratchet_sieve
