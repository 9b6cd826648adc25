#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/estimates.h"

namespace ratchet_sieve
{

/// How far the error of an estimate is from the requested one.
struct Attainment
{
  std::optional<double>
      ratio;  ///< half-width over the requested half-width, the largest of several; nothing if one is unknown
  bool trusted = false;

  bool reached() const { return trusted && ratio && *ratio <= 1.0; }
};

/// The statistical errors of a run at its time(), with the confidence level of its scene
/// (AccuracyDefinition).
struct Certainty
{
  SteadyMeans means;
  std::optional<SeparationEstimate> separation;
  std::optional<Attainment> to_mean_vx;  ///< nothing if the scene does not request it
  std::optional<Attainment> to_quality;

  /// Whether all requested errors are reached; nothing if none is requested.
  std::optional<bool> reached() const;

  /// The larger of the two ratios; nothing if one is unknown.
  std::optional<double> ratio() const;
};

/// Does not change the run.
Certainty certaintyOf(const Simulation& simulation);

/// One line for each requested error that was not reached: the achieved error, and the duration needed.
std::vector<std::string> shortfalls(const Simulation& simulation, const Certainty& certainty);

/// A warning of one line that names the species whose mean velocity is of too short a run to have an error;
/// empty if there are none, and for a machine that runs empty.
std::string unknownErrorText(const Simulation& simulation);

/// The first time, not before `time`, at which the run checks whether it may end early; each is about 1.2
/// times the one before. The checks are few, because each check adds to the probability that the error is too
/// small by chance just then. The times are multiples of the block length counted from `settle`. So they do
/// not depend on how a run is advanced, saved or resumed.
double lookFrom(const Simulation& simulation, double time);

}  // namespace ratchet_sieve
