#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/quality_estimate.h"
#include "ratchet_sieve/recording/steady_mean.h"

namespace ratchet_sieve
{

/// How far an estimate is from what the scene asks for.
struct Approach
{
  std::optional<double> ratio;  ///< the half-width, the largest of several, over the one asked for; nothing
                                ///< while one is not known
  bool trusted = false;

  bool reached() const { return trusted && ratio && *ratio <= 1.0; }
};

/// How sure a run's results are at its time(), with the confidence of its scene (AccuracyDefinition).
struct Certainty
{
  SteadyMeans means;
  std::optional<QualityEstimate> quality;
  std::optional<Approach> to_mean_vx;  ///< nothing where it is not asked for
  std::optional<Approach> to_quality;

  /// Whether all that is asked for is; nothing where nothing is.
  std::optional<bool> reached() const;

  /// The larger of the two ratios; nothing while one is not known.
  std::optional<double> ratio() const;
};

/// Reads the run and changes nothing of it.
Certainty certaintyOf(const Simulation& simulation);

/// One line for each thing that was asked for and not reached: what came of it, and what it would take.
std::vector<std::string> shortfalls(const Simulation& simulation, const Certainty& certainty);

/// The times at which a run is asked whether it may end, each about 1.2 times the one before: an error that
/// is looked at often is once in a while too small by chance, and that is when the run would end. They go by
/// the blocks of the series, counted from `settle`, and so do not depend on how a run is advanced, saved or
/// resumed.
class LookTimes
{
public:
  /// From simulation.time() on.
  explicit LookTimes(const Simulation& simulation);

  double next() const { return next_; }  ///< [s]
  void pass();

private:
  const Simulation& simulation_;
  std::uint64_t blocks_;
  double next_ = 0.0;
};

}  // namespace ratchet_sieve
