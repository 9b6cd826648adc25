#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/results.h"
#include "state/disk_ids.h"
#include "state/disk_record.h"

namespace ratchet_sieve
{

/// Detects an inelastic collapse: a disk has more events within the machine's time scale than the scene
/// allows (McNamara & Young, Phys. Fluids A 4, 496 (1992), doi:10.1063/1.858323). The same happens to a disk
/// that is wedged between bodies.
///
/// If the scene lets the run continue, the disk's slow contacts are lossless until a whole time scale has
/// passed without a collapse. They lose no energy, which frees a wedged disk, and have a minimum rebound
/// speed, which lets a resting disk hop. The minimum doubles with every consecutive collapse. Slow is a
/// contact at which the disk has no more energy than the heaviest one after a fall from a tooth's height:
/// were all lossless, a disk without room would take energy from a moving base without bound. A disk that is
/// not freed by that is stuck, and ends the run.
class CollapseWatch
{
public:
  /// @param time_scale of the machine [s]; @param speed_scale of a fall from a tooth's height [m/s]
  /// @param disks with their windows, by slot; @param ids for messages; both outlive this
  CollapseWatch(const ContactDefinition& contact, double time_scale, double speed_scale,
                SlotArray<DiskRecord>& disks, const DiskIds& ids);

  /// Counts an event of a disk. @return whether it exceeds the limit; the disk is lossless from then on
  bool count(std::uint32_t slot, double time)
  {
    CollapseWindow& window = disks_[slot].window;
    if (time >= window.end)
      window = {time + time_scale_, 0, 0};
    if (++window.events <= limit_)
      return false;
    collapse(slot, time);
    return true;
  }

  /// Counts an event of a disk, unless it exceeds the limit or the disk is lossless. May be called by several
  /// threads for different disks at the same time.
  /// @return whether it was counted
  bool countOrdinary(std::uint32_t slot, double time)
  {
    CollapseWindow window = disks_[slot].window;
    if (lossless(slot))
      return false;
    if (time >= window.end)
      window = {time + time_scale_, 0, 0};
    if (++window.events > limit_)
      return false;
    disks_[slot].window = window;
    return true;
  }

  /// Whether an event of the disk at this time would end the run.
  bool endsAt(std::uint32_t slot, double time) const
  {
    const CollapseWindow& window = disks_[slot].window;
    return time < window.end && window.events >= limit_ &&
           (contact_.on_collapse == CollapseAction::STOP || window.level >= MAX_LEVEL);
  }

  void setCounts(const CollapseCounts& counts) { counts_ = counts; }

  /// Whether the disk's slow contacts lose no energy at present. Fast while there was no collapse at all.
  bool lossless(std::uint32_t slot) const { return counts_.count > 0 && disks_[slot].window.level > 0; }

  /// Contacts of the disk that are slower are slow [m/s].
  double slow(std::uint32_t slot) const
  {
    return speed_scale_ * std::sqrt(heaviest_ / disks_[slot].properties.mass);
  }

  /// Minimum rebound speed of a lossless disk [m/s].
  double floorSpeed(std::uint32_t slot) const
  {
    return std::max(std::min(floorOf(disks_[slot].window.level), slow(slot)), contact_.min_rebound_speed);
  }

  /// Whether MAX_LEVEL consecutive collapses did not free the disk.
  bool stuck(std::uint32_t slot) const { return disks_[slot].window.level > MAX_LEVEL; }

  /// Whether the run must end: by the scene's `on_collapse`, or because a disk is stuck.
  bool stops() const { return stops_; }

  const CollapseCounts& counts() const { return counts_; }

  /// One line with the figures, and with what can help. @pre counts().count > 0
  std::string text() const;

  /// A disk of this mass is added [kg].
  void added(double mass) { heaviest_ = std::max(heaviest_, mass); }

  /// The epoch's start [s].
  void setEpoch(double start) { epoch_start_ = start; }

  void archive(StateArchive& state) { state(epoch_start_, heaviest_, counts_, first_stuck_, stops_); }

private:
  /// After this many consecutive collapses the disk cannot be freed.
  static constexpr std::uint32_t MAX_LEVEL = 16;

  /// A disk that collapses although its contacts are lossless.
  struct Stuck
  {
    double time;  ///< of the run [s]
    std::uint32_t disk;

    void archive(StateArchive& state) { state(time, disk); }
  };

  void collapse(std::uint32_t slot, double time);
  double floorOf(std::uint32_t level) const;

  ContactDefinition contact_;
  SlotArray<DiskRecord>& disks_;
  const DiskIds& ids_;
  std::uint32_t limit_;
  double time_scale_;
  double speed_scale_;
  double epoch_start_ = 0.0;
  double heaviest_ = 0.0;  ///< of all disks so far [kg]
  CollapseCounts counts_;
  std::optional<Stuck> first_stuck_;
  bool stops_ = false;
};

}  // namespace ratchet_sieve
