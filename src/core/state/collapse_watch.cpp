#include "state/collapse_watch.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

namespace ratchet_sieve
{
namespace
{
/// First minimum rebound speed of a lossless disk, as a fraction of the speed of a fall from a tooth's
/// height. Hops at this speed occur some hundred times per time scale.
constexpr double FIRST_FLOOR = 1e-3;

/// After this many consecutive collapses the minimum rebound speed is one at which dense heaps did not
/// collapse (docs/stability.md).
constexpr std::uint32_t HELPFUL_LEVEL = 6;
}  // namespace

CollapseWatch::CollapseWatch(const ContactDefinition& contact, double time_scale, double speed_scale,
                             SlotArray<DiskRecord>& disks, const DiskIds& ids)
    : contact_(contact),
      disks_(disks),
      ids_(ids),
      limit_(static_cast<std::uint32_t>(contact.collapse_events)),
      time_scale_(time_scale),
      speed_scale_(speed_scale)
{
}

double CollapseWatch::floorOf(std::uint32_t level) const
{
  return std::ldexp(FIRST_FLOOR * speed_scale_, static_cast<int>(level) - 1);
}

void CollapseWatch::collapse(std::uint32_t slot, double time)
{
  CollapseWindow& window = disks_[slot].window;
  window = {time + time_scale_, 0, window.level + 1};
  // Independent disks are advanced one by one, in any order. The first collapse is the earliest; at equal
  // times, the one with the smallest id.
  const double run_time = epoch_start_ + time;
  const std::uint32_t id = ids_.of(slot);
  if (counts_.count == 0 || std::tie(run_time, id) < std::tie(counts_.first_time, counts_.first_disk))
  {
    counts_.first_time = run_time;
    counts_.first_disk = id;
  }
  ++counts_.count;
  if (stuck(slot) &&
      (!first_stuck_ || std::tie(run_time, id) < std::tie(first_stuck_->time, first_stuck_->disk)))
    first_stuck_ = Stuck{run_time, id};
  stops_ = first_stuck_ || contact_.on_collapse == CollapseAction::STOP;
}

std::string CollapseWatch::text() const
{
  std::ostringstream text;
  text.precision(12);
  text << "inelastic collapse: disk " << (first_stuck_ ? first_stuck_->disk : counts_.first_disk)
       << " had more than " << limit_ << " events within " << time_scale_ << " s at "
       << (first_stuck_ ? first_stuck_->time : counts_.first_time) << " s";
  text.precision(3);
  if (first_stuck_)
    text << ", although its slow contacts were lossless: it has no room";
  else if (!stops_)
    text << "; its slow contacts were lossless for a while; collapses so far: " << counts_.count;
  else if (contact_.min_rebound_speed < floorOf(HELPFUL_LEVEL))
    text << "; a contact.min_rebound_speed of " << floorOf(HELPFUL_LEVEL)
         << " m/s or more may avoid it, or contact.on_collapse: rebound, if the disk has room";
  else
    text << "; contact.on_collapse: rebound may free it, if it has room";
  return text.str();
}

}  // namespace ratchet_sieve
