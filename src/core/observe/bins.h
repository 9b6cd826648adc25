#pragma once

#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/results.h"
#include "state/observer.h"

namespace ratchet_sieve
{

class SystemState;

/// The disks and their mass by place: in the machine, and in the bins at its ends. Of size classes, the
/// numbers alone.
class Bins final : public Observer
{
public:
  explicit Bins(const SystemState& system);

  void entered(const Disk& disk, double time) override;
  void departed(const Departure& departure) override;

  /// @throws StateError if the state is of other species
  void archive(StateArchive& state) override;

  const std::vector<SpeciesBins>& ofSpecies() const { return of_species_; }
  const std::vector<SpeciesBins>& ofSizeClasses() const { return of_size_classes_; }

private:
  const SystemState& system_;
  std::vector<SpeciesBins> of_species_;
  std::vector<SpeciesBins> of_size_classes_;
};

/// What has left within an interval that ends at the present time. No part of the saved state.
class RecentExits final : public Observer
{
public:
  explicit RecentExits(const SystemState& system) : system_(system) {}

  void departed(const Departure& departure) override;

  // See Simulation. @param time the present one of the run [s]
  void keep(double length, double time);
  ExitWindow window(double time, double not_before) const;

private:
  const SystemState& system_;
  double length_ = 0.0;                                     ///< [s]
  double from_ = -std::numeric_limits<double>::infinity();  ///< in the run's time [s]
  std::deque<std::pair<double, Departure>> exits_;          ///< in the order of time: the run's [s]
};

}  // namespace ratchet_sieve
