#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "ratchet_sieve/core/contact_outcome.h"
#include "ratchet_sieve/core/disk_ids.h"
#include "ratchet_sieve/core/luding_law.h"

namespace ratchet_sieve
{

/// The impulse that the base gave to the disks since the means began. Sums go by disk, so that they have the
/// same bits in whatever order disks that do not see each other are advanced.
class BaseImpulses
{
public:
  /// In the world [N s].
  struct Sum
  {
    double x = 0.0;
    double y = 0.0;

    void archive(StateArchive& state) { state(x, y); }
  };

  void reserve(std::size_t count) { given_.reserve(count); }
  void added() { given_.emplace_back(); }

  void take(const ContactOutcome& outcome)
  {
    if (outcome.j != ContactOutcome::BASE)
      return;
    const PushOf<double> push =
        pushOf<double>({outcome.normal_impulse, outcome.tangential_impulse}, outcome.nx, outcome.ny);
    given_[outcome.i].x += push.x;
    given_[outcome.i].y += push.y;
  }

  /// What one disk was given; a batch of disks takes its outcomes up in a sum of its own.
  const Sum& of(std::uint32_t slot) const { return given_[slot]; }
  void set(std::uint32_t slot, const Sum& sum) { given_[slot] = sum; }

  Sum total() const
  {
    return std::accumulate(given_.begin(), given_.end(), gone_,
                           [](const Sum& a, const Sum& b) {
                             return Sum{a.x + b.x, a.y + b.y};
                           });
  }

  void restart()
  {
    std::fill(given_.begin(), given_.end(), Sum());
    gone_ = Sum();
  }

  /// @param slots of the disks that stay, @param left of those that do not
  void keep(const std::vector<std::uint32_t>& slots, const std::vector<std::uint32_t>& left)
  {
    for (const std::uint32_t slot : left)
      gone_ = {gone_.x + given_[slot].x, gone_.y + given_[slot].y};
    keepSlots(given_, slots);
  }

  bool fits(std::size_t disks) const { return given_.size() == disks; }

  void archive(StateArchive& state) { state(given_, gone_); }

private:
  std::vector<Sum> given_;  ///< per slot
  Sum gone_;                ///< to disks whose slots were given up
};

}  // namespace ratchet_sieve
