#include "ratchet_sieve/ros/seek_parameters.h"

#include <cmath>

#include <ros/console.h>
#include <ros/names.h>

#include "ratchet_sieve/ros/node_parameters.h"
#include "ratchet_sieve/ros/sieve_search.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{
constexpr double LONGEST_TIME = 1e6;    // s
constexpr double MOST_DISKS = 1e9;      // of a window
constexpr double MOST_TRIALS = 1e3;     // at one inclination
constexpr double MOST_CONFIDENCE = 10;  // standard errors

/// Smallest step, as a fraction of the range; the search would not end with smaller ones.
constexpr double FINEST = 1e-4;

/// The limits of the sieve's inclination, from its parameters.
Interval inclinationLimits(const std::string& sieve)
{
  ParameterReader reader{ros::NodeHandle(sieve)};
  SlewRates slew_rates;
  return readSetpoints(reader, slew_rates)[indexOf(Quantity::INCLINATION)].limits;
}

Goal readGoal(ParameterReader& reader)
{
  const std::string text = reader.text("goal", goalText({}));
  if (const std::optional<Goal> goal = goalFromText(text))
    return *goal;
  throw ParameterError("parameter " + reader.fullName("goal") + ": " + shownText(text) + ": must be " +
                       GOAL_FORMS);
}

void readSearch(ParameterReader& reader, SeekParameters& parameters)
{
  SearchOptions& search = parameters.search;
  search.goal = readGoal(reader);
  const Interval limits = inclinationLimits(parameters.sieve);
  search.min = reader.number("inclination/min", limits.min, limits.min, limits.max);
  search.max = reader.number("inclination/max", limits.max, search.min, limits.max);
  const double start = reader.number("inclination/start", NAN, search.min, search.max);
  if (std::isfinite(start))
    parameters.start = start;
  const double range = search.max - search.min;
  search.resolution = reader.number("inclination/resolution", search.resolution, FINEST * range, 1.0);
  search.step = reader.number("inclination/step", search.step, search.resolution, 1.0);
  search.confidence = reader.number("confidence", search.confidence, 0.0, MOST_CONFIDENCE);
  search.most_trials =
      static_cast<unsigned>(reader.number("most_trials", search.most_trials, 1.0, MOST_TRIALS));
  search.drop = reader.number("drop", search.drop, 0.0, 1.0);
}

void readTrial(ParameterReader& reader, TrialOptions& trial)
{
  trial.dwell = reader.number("dwell", trial.dwell, 0.0, LONGEST_TIME);
  trial.window = reader.number("window", trial.window, 0.0, LONGEST_TIME);
  trial.longest_window = reader.number("longest_window", trial.longest_window, trial.window, LONGEST_TIME);
  trial.least_disks = static_cast<std::uint64_t>(
      reader.number("least_disks", static_cast<double>(trial.least_disks), 1.0, MOST_DISKS));
}
}  // namespace

SeekParameters readSeekParameters(const ros::NodeHandle& private_node)
{
  SeekParameters parameters;
  ParameterReader reader(private_node);
  parameters.goal_name = reader.fullName("goal");
  parameters.sieve = ros::names::resolve(reader.text("sieve", DEFAULT_SIEVE));
  readSearch(reader, parameters);
  readTrial(reader, parameters.trial);
  for (const std::string& name : reader.unknown({}))
    ROS_WARN("parameter %s: not known, and ignored", name.c_str());
  return parameters;
}

}  // namespace ratchet_sieve
