#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "state/contact_outcome.h"
#include "state/disk_ids.h"

namespace ratchet_sieve
{

/// The impulse that the base gave to the disks since the means began. Sums go by disk, so that they have the
/// same bits in whatever order disks that do not see each other are advanced. In the world [N s].
class BaseImpulses
{
public:
  void reserve(std::size_t count) { given_.reserve(count); }
  void added() { given_.push_back(Eigen::Vector2d::Zero()); }

  void take(const ContactOutcome& outcome)
  {
    if (outcome.j == ContactOutcome::BASE)
      given_[outcome.i] += impulseOf(outcome);
  }

  /// What one disk was given; a batch of disks takes its outcomes up in a sum of its own.
  const Eigen::Vector2d& of(std::uint32_t slot) const { return given_[slot]; }
  void set(std::uint32_t slot, const Eigen::Vector2d& sum) { given_[slot] = sum; }

  Eigen::Vector2d total() const
  {
    Eigen::Vector2d sum = gone_;
    for (const Eigen::Vector2d& given : given_)
      sum += given;
    return sum;
  }

  void restart()
  {
    std::fill(given_.begin(), given_.end(), Eigen::Vector2d::Zero());
    gone_ = Eigen::Vector2d::Zero();
  }

  /// @param slots of the disks that stay, @param left of those that do not
  void keep(const std::vector<std::uint32_t>& slots, const std::vector<std::uint32_t>& left)
  {
    for (const std::uint32_t slot : left)
      gone_ += given_[slot];
    keepSlots(given_, slots);
  }

  bool fits(std::size_t disks) const { return given_.size() == disks; }

  void archive(StateArchive& state) { state(given_, gone_); }

private:
  std::vector<Eigen::Vector2d> given_;              ///< per slot
  Eigen::Vector2d gone_ = Eigen::Vector2d::Zero();  ///< to disks that were compacted away
};

}  // namespace ratchet_sieve
