#include "ratchet_sieve/ros/seek_node.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <ros/console.h>
#include <std_msgs/Float64.h>

#include "queue_size.h"
#include "ratchet_sieve/live/setpoint.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{
// All of wall time [s].
constexpr double WATCH_PERIOD = 0.2;   ///< interval between checks whether the sieve has taken the setpoint
constexpr double REPEAT_AFTER = 0.5;   ///< until a setpoint that was not taken is sent again
constexpr double SILENT_AFTER = 10.0;  ///< warning after this time without a message
constexpr double WARN_EVERY = 10.0;

/// The scene without the keys that setpoints change and without the positions of disks.
SceneDefinition withoutState(SceneDefinition scene)
{
  scene.base.inclination = scene.base.frequency = scene.base.amplitude = scene.base.phase = 0.0;
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;
  scene.initial.clear();
  return scene;
}

void warnOfScene(const std::string& sieve, const SceneDefinition& scene)
{
  if (scene.boundary != Boundary::OPEN)
    ROS_WARN("the boundary of %s is not open: no disk leaves, so there is nothing to compare", sieve.c_str());
  else if (scene.species.size() < 2)
    ROS_WARN("%s has one species: there is nothing to separate", sieve.c_str());
  else if (scene.feed.rate == 0.0)
    ROS_WARN("%s has no feed: the search stops when its base is empty", sieve.c_str());
}

std::string binsText(const Separation& separation)
{
  std::ostringstream text;
  for (std::size_t k = 0; k < separation.bins.size(); ++k)
    text << (k > 0 ? ", " : "") << separation.species[k] << " " << separation.bins[k].left << " left "
         << separation.bins[k].right << " right";
  return text.str();
}

std::string valueText(const Goal& goal, const Measured& measured, const char* if_undefined)
{
  if (!measured.defined)
    return if_undefined;
  return goal.isShare() ? fmt::format("{:.2f} +- {:.2f}", measured.value, measured.error)
                        : fmt::format("{:.3g} +- {:.2g}", measured.value, measured.error);
}

/// The name of the goal's value.
std::string nameOf(const Goal& goal)
{
  return goal.measure == Measure::QUALITY ? "Q" : goalText(goal);
}

template <typename Flag>
void put(const Measured& measured, double& value, double& error, Flag& defined)
{
  value = measured.value;
  error = measured.error;
  defined = measured.defined;
}

/// @throws ParameterError if the goal is of a species that the scene does not have
void requireSpecies(const SeekParameters& parameters, const SceneDefinition& scene)
{
  const std::vector<std::string> names = speciesNames(scene);
  const Goal& goal = parameters.search.goal;
  if (!goal.species.empty() && std::find(names.begin(), names.end(), goal.species) == names.end())
    throw ParameterError(fmt::format("parameter {}: {}: SPECIES must be one of {}'s: {}",
                                     parameters.goal_name, goalText(goal), parameters.sieve,
                                     fmt::join(names, ", ")));
}
}  // namespace

std::string trialText(const SeekReport& report)
{
  const Separation& trial = report.separation;
  std::string text =
      fmt::format("trial {}, {}: {:.4f} rad, {:.1f} to {:.1f} s: {} {} ({}", report.trial,
                  phaseName(report.phase), trial.inclination, trial.begin, trial.end, nameOf(report.goal),
                  valueText(report.goal, report.score.goal, "undefined"), binsText(trial));
  if (trial.real_time_factor > 0.0)
    text += fmt::format("; {:.3g} times real time", trial.real_time_factor);
  return text + fmt::format("); best {:.4f} rad, {} {}; next {} {:.4f} rad", report.best, nameOf(report.goal),
                            valueText(report.goal, report.best_score.goal, "not measured yet"),
                            phaseName(report.next_phase), report.next);
}

SeekTrial toMessage(const SeekReport& report)
{
  const Separation& trial = report.separation;
  SeekTrial message;
  message.header.stamp = stampOf(trial.end);
  message.header.frame_id = WORLD_FRAME_ID;
  message.time = trial.end;
  message.begin = trial.begin;
  message.trial = report.trial;
  message.phase = phaseName(report.phase);
  message.inclination = trial.inclination;
  message.goal = goalText(report.goal);
  message.species = trial.species;
  for (const SpeciesBins& bins : trial.bins)
  {
    message.left.push_back(bins.left);
    message.right.push_back(bins.right);
    message.on_base.push_back(bins.on_base);
  }
  message.granular_temperature = trial.granular_temperature;
  put(report.score.goal, message.value, message.value_error, message.value_defined);
  put(report.score.quality, message.quality, message.quality_error, message.quality_defined);
  message.balance = report.score.balance;
  message.best_inclination = report.best;
  put(report.best_score.goal, message.best_value, message.best_value_error, message.best_value_defined);
  put(report.best_score.quality, message.best_quality, message.best_quality_error,
      message.best_quality_defined);
  message.next_phase = phaseName(report.next_phase);
  message.next_inclination = report.next;
  return message;
}

SeekNode::SeekNode(ros::NodeHandle private_node)
    : parameters_(readSeekParameters(private_node)),
      control_(parameters_.search, parameters_.trial, parameters_.start),
      heard_at_(ros::SteadyTime::now())
{
  trials_ = private_node.advertise<SeekTrial>("trials", QUEUE_SIZE, true);
  ros::NodeHandle sieve(parameters_.sieve);
  setpoint_ = sieve.advertise<std_msgs::Float64>(setpointTopic(Quantity::INCLINATION), QUEUE_SIZE);
  const auto hints = ros::TransportHints().tcpNoDelay();
  base_ = sieve.subscribe<BaseState>("base", QUEUE_SIZE,
                                     boost::function<void(const ros::MessageEvent<const BaseState>&)>(
                                         [this](const auto& event) { hear(event, base_connection_); }),
                                     ros::VoidConstPtr(), hints);
  bins_ = sieve.subscribe<BinCounts>("bins", QUEUE_SIZE,
                                     boost::function<void(const ros::MessageEvent<const BinCounts>&)>(
                                         [this](const auto& event) { hear(event, bins_connection_); }),
                                     ros::VoidConstPtr(), hints);
  statistics_ = sieve.subscribe<SieveStatistics>(
      "statistics", QUEUE_SIZE,
      [this](const SieveStatistics::ConstPtr& message) { control_.take(toFrame(*message)); },
      ros::VoidConstPtr(), hints);
  scene_ = sieve.subscribe<SceneDescription>(
      "scene", 1, [this](const SceneDescription::ConstPtr& message) { takeScene(*message); });
  ROS_INFO("seeking the best inclination of %s from %g to %g rad, by %s", parameters_.sieve.c_str(),
           parameters_.search.min, parameters_.search.max, goalText(parameters_.search.goal).c_str());
  timer_ = private_node.createSteadyTimer(ros::WallDuration(WATCH_PERIOD),
                                          [this](const ros::SteadyTimerEvent&) { watch(); });
}

/// A message over another connection comes from another process: the sieve was restarted, even if the stamps
/// continue to increase.
template <typename Message>
void SeekNode::hear(const ros::MessageEvent<const Message>& event,
                    boost::shared_ptr<ros::M_string>& connection)
{
  if (connection && connection != event.getConnectionHeaderPtr())
  {
    if (&connection == &base_connection_)  // on one of the two topics, so that it counts once
      ROS_INFO("%s was restarted: the trial begins again", parameters_.sieve.c_str());
    control_.interrupt();
  }
  connection = event.getConnectionHeaderPtr();
  heard_at_ = ros::SteadyTime::now();
  try
  {
    if (const auto report = control_.take(toFrame(*event.getMessage())))
      publish(*report);
  }
  catch (const std::invalid_argument& error)
  {
    ROS_WARN_THROTTLE(1.0, "%s: a message is ignored: %s", parameters_.sieve.c_str(), error.what());
  }
  command();
}

void SeekNode::publish(const SeekReport& report)
{
  ROS_INFO("%s", trialText(report).c_str());
  trials_.publish(toMessage(report));
}

void SeekNode::takeScene(const SceneDescription& message)
{
  try
  {
    const SceneDefinition scene = sceneFromText(message.yaml, scene_.getTopic()).definition;
    const std::string hash = sceneHash(withoutState(scene));
    if (hash != scene_hash_)
    {
      requireSpecies(parameters_, scene);
      warnOfScene(parameters_.sieve, scene);
      if (scene_hash_)
        control_.restart();
    }
    scene_hash_ = hash;
  }
  catch (const SceneError& error)
  {
    ROS_WARN("%s", error.what());
  }
}

void SeekNode::command()
{
  if (control_.restarts() > restarts_)
    ROS_WARN("%s has changed (what it attains, its drive or its scene): the search restarts at %.4f rad",
             parameters_.sieve.c_str(), *control_.setpoint());
  restarts_ = control_.restarts();
  // A sieve that was reset has lost its setpoint: it is sent again at once.
  if (control_.interruptions() > interruptions_)
    sent_.reset();
  interruptions_ = control_.interruptions();
  const std::optional<double> setpoint = control_.setpoint();
  if (!setpoint || control_.followed())
    return;
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (sent_ == setpoint && (now - sent_at_).toSec() < REPEAT_AFTER)
    return;
  std_msgs::Float64 message;
  message.data = *setpoint;
  setpoint_.publish(message);
  if (sent_ == setpoint)
    ROS_WARN_THROTTLE(WARN_EVERY, "%s does not follow the setpoint %.4f rad: sent again",
                      parameters_.sieve.c_str(), *setpoint);
  sent_ = setpoint;
  sent_at_ = now;
}

void SeekNode::watch()
{
  if (base_.getNumPublishers() == 0)
    control_.interrupt();
  else
    command();
  warnOfSilence();
}

void SeekNode::warnOfSilence()
{
  const bool silent = (ros::SteadyTime::now() - heard_at_).toSec() > SILENT_AFTER;
  if (silent && !silent_)
    ROS_WARN("no message from %s for %g s: it is paused or not running", parameters_.sieve.c_str(),
             SILENT_AFTER);
  if (!silent && silent_)
    ROS_INFO("messages from %s arrive again", parameters_.sieve.c_str());
  silent_ = silent;
}

}  // namespace ratchet_sieve
