#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "state/contact_outcome.h"
#include "state/disk_ids.h"

namespace ratchet_sieve
{

/// The impulse given by the base to the disks since the means began. Summed per disk, so that the bits do not
/// depend on the order in which independent disks are advanced. World frame [N s].
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

  /// The impulse given to one disk. SIMD batches add to a sum of their own.
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

  /// @param slots of the disks that stay, @param left of those removed
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
  Eigen::Vector2d gone_ = Eigen::Vector2d::Zero();  ///< to disks removed by compaction
};

}  // namespace ratchet_sieve
