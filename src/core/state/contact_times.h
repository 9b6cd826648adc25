#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "state/disk_ids.h"
#include "state/observer.h"

namespace ratchet_sieve
{

/// The time of each disk's last contact, for the contact duration t_c. Empty if the plan has no contact
/// times.
class ContactTimes final : public Observer
{
public:
  explicit ContactTimes(bool kept) : kept_(kept) {}

  void entered(const Disk& /*disk*/) override
  {
    if (kept_)
      times_.push_back(-std::numeric_limits<double>::infinity());
  }

  void take(const ContactOutcome& outcome) override
  {
    if (!kept_)
      return;
    times_[outcome.i] = outcome.time;
    if (outcome.j != ContactOutcome::BASE)
      times_[outcome.j] = outcome.time;
  }

  /// Of one disk's last contact; 0 if there are no contact times.
  double of(std::uint32_t slot) const { return kept_ ? times_[slot] : 0.0; }
  void set(std::uint32_t slot, double time)
  {
    if (kept_)
      times_[slot] = time;
  }

  /// Whether the disk's last contact was less than `duration` ago.
  bool within(double duration, std::uint32_t slot, double time) const
  {
    return kept_ && time - times_[slot] < duration;
  }

  void compact(const Compaction& compaction) override
  {
    if (kept_)
      keepSlots(times_, compaction.kept);
  }

  void rebase(double length) override
  {
    for (double& time : times_)
      time -= length;
  }

  bool fits(std::size_t slots) const override { return times_.size() == (kept_ ? slots : 0); }
  void archive(StateArchive& state) override { state(times_); }

private:
  bool kept_;
  std::vector<double> times_;  ///< per slot, local to the epoch [s]
};

}  // namespace ratchet_sieve
