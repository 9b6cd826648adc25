#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "state/contact_outcome.h"
#include "state/disk_ids.h"

namespace ratchet_sieve
{

/// The time of each disk's last contact, for the contact duration t_c. Empty if the plan has no contact
/// times.
class ContactTimes
{
public:
  explicit ContactTimes(bool kept) : kept_(kept) {}

  void added()
  {
    if (kept_)
      times_.push_back(-std::numeric_limits<double>::infinity());
  }

  void take(const ContactOutcome& outcome)
  {
    if (!kept_)
      return;
    times_[outcome.i] = outcome.time;
    if (outcome.j != ContactOutcome::BASE)
      times_[outcome.j] = outcome.time;
  }

  /// Whether the disk's last contact was less than `duration` ago.
  bool within(double duration, std::uint32_t slot, double time) const
  {
    return kept_ && time - times_[slot] < duration;
  }

  void keep(const std::vector<std::uint32_t>& slots)
  {
    if (kept_)
      keepSlots(times_, slots);
  }

  void rebase(double length)
  {
    for (double& time : times_)
      time -= length;
  }

  bool fits(std::size_t disks) const { return times_.size() == (kept_ ? disks : 0); }
  void archive(StateArchive& state) { state(times_); }

private:
  bool kept_;
  std::vector<double> times_;  ///< per slot, local to the epoch [s]
};

}  // namespace ratchet_sieve
