#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/prefetch.h"
#include "state/disk_ids.h"
#include "state/observer.h"
#include "state/row_sums.h"

namespace ratchet_sieve
{

/// The impulse given by the base to the disks since the means began. Summed per disk, so that the bits do not
/// depend on the order in which independent disks are advanced. World frame [N s].
class BaseImpulses final : public Observer
{
public:
  void reserve(std::size_t count) override { given_.reserve(count); }
  void entered(const Disk& /*disk*/) override { given_.push_back(Eigen::Vector2d::Zero()); }

  void take(const ContactOutcome& outcome) override
  {
    if (outcome.j == ContactOutcome::BASE)
      given_[outcome.i] += impulseOf(outcome);
  }

  /// The impulse given to one disk.
  const Eigen::Vector2d& of(std::uint32_t slot) const { return given_[slot]; }
  void prefetchSum(std::uint32_t slot) const { prefetch(given_[slot]); }

  /// For SIMD batches, which add to sums of their own.
  void load(std::uint32_t slot, RowSums& sums) const
  {
    sums.impulse_x = given_[slot].x();
    sums.impulse_y = given_[slot].y();
  }
  void store(std::uint32_t slot, const RowSums& sums) { given_[slot] = {sums.impulse_x, sums.impulse_y}; }

  Eigen::Vector2d total() const
  {
    Eigen::Vector2d sum = gone_;
    for (const Eigen::Vector2d& given : given_)
      sum += given;
    return sum;
  }

  void restart(double /*time*/) override
  {
    std::fill(given_.begin(), given_.end(), Eigen::Vector2d::Zero());
    gone_ = Eigen::Vector2d::Zero();
  }

  void compact(const Compaction& compaction) override
  {
    for (const std::uint32_t slot : compaction.gone)
      gone_ += given_[slot];
    keepSlots(given_, compaction.kept);
  }

  bool fits(std::size_t slots) const override { return given_.size() == slots; }

  void archive(StateArchive& state) override { state(given_, gone_); }

private:
  std::vector<Eigen::Vector2d> given_;              ///< per slot
  Eigen::Vector2d gone_ = Eigen::Vector2d::Zero();  ///< to disks removed by compaction
};

}  // namespace ratchet_sieve
