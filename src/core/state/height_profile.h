#pragma once

#include <limits>
#include <vector>

#include "model/motion_steps.h"
#include "state/height_slices.h"
#include "state/observable.h"

namespace ratchet_sieve
{

/// Number density, mean velocity and granular temperature over the height above the base, since the end of
/// `settle`: means over time, for each of equal parts of the drive's period. Height is measured from the line
/// through the lowest corners of the teeth, along the base's normal, and velocities relative to the base.
/// Exact in time but for the steps of MotionSteps.
class HeightProfile final : public Observable
{
public:
  static constexpr const char* NAME = "height_profile";

  /// The least number of parts of a period in which temperatures are taken: over a whole period, the common
  /// motion of all disks would count as temperature.
  static constexpr std::size_t LEAST_PARTS = 16;

  /// @param system outlives this
  explicit HeightProfile(const SystemState& system);

  Wishes wishes() const override
  {
    Wishes wishes;
    wishes.flights = true;
    return wishes;
  }
  void flew(const Flight& flight) override;
  void restart(double time) override;
  void endSegment(double time) override { countUntil(time, sums_); }
  void rebase(double length) override { sums_.since -= length; }
  void archive(StateArchive& state) override;
  Observed observed(double time) const override;

private:
  struct Sums
  {
    double since = std::numeric_limits<double>::infinity();  ///< all flights until then are counted [s]
    std::vector<double> spans;                               ///< time counted in each part of a period [s]
    std::vector<HeightSlices> species;
  };

  Sums noSums() const;

  /// Counts what disks in flight do until `time`.
  void countUntil(double time, Sums& sums) const;
  void count(const Flight& flight, Sums& sums) const;

  ObservedRow row(std::size_t species, const Sums& sums) const;

  /// Adds the lines of the table of one of the phases that the scene asks for.
  void addPhase(std::size_t species, std::size_t phase, const Sums& sums,
                std::vector<ObservedColumn>& table) const;

  const SystemState& system_;
  std::size_t phases_;
  double slice_;  ///< height of a slice [m]
  MotionSteps steps_;
  Sums sums_;
};

}  // namespace ratchet_sieve
