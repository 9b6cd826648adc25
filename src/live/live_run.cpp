#include "ratchet_sieve/live/live_run.h"

#include <algorithm>
#include <utility>

#include "ratchet_sieve/recording/commands.h"

namespace ratchet_sieve
{

LiveRun::LiveRun(const SceneDefinition& scene, const FrameRates& rates, std::vector<CommandFrame> opening,
                 double start_time, double end_time, FrameSampler::WallClock wall_clock,
                 const PourObserver& pour_observer)
    : simulation_(scene, start_time, pour_observer),
      wall_clock_(std::move(wall_clock)),
      sampler_(rates, start_time, wall_clock_),
      end_time_(end_time),
      opening_(std::move(opening))
{
  for (CommandFrame& command : opening_)
  {
    command.time = start_time;
    apply(command, simulation_);
  }
}

void LiveRun::record(FrameSink& recorder, const FrameRates& rates)
{
  recording_.emplace(Recording{recorder, {rates, simulation_.startTime(), wall_clock_}});
  recording_->sampler.setUnderWay(under_way_);
}

void LiveRun::setUnderWay(bool under_way)
{
  under_way_ = under_way;
  sampler_.setUnderWay(under_way);
  if (recording_)
    recording_->sampler.setUnderWay(under_way);
}

double LiveRun::nextTime() const
{
  const double next = std::min(sampler_.nextTime(), end_time_);
  return recording_ ? std::min(next, recording_->sampler.nextTime()) : next;
}

bool LiveRun::statisticsWanted(const FrameSink& sink) const
{
  return statistics_kept_ || sink.wants(FrameKind::STATISTICS) ||
         (recording_ && recording_->sink.wants(FrameKind::STATISTICS));
}

/// Each observed period evaluates the velocities of all disks eight times.
void LiveRun::observePeriods(bool observe)
{
  if (observe == periods_observed_)
    return;
  periods_observed_ = observe;
  if (!observe)
    return simulation_.observePeriods({});
  sampler_.restartWindow(simulation_);
  if (recording_)
    recording_->sampler.restartWindow(simulation_);
  simulation_.observePeriods(
      [this](const PeriodRecord& period)
      {
        sampler_.take(period);
        if (recording_)
          recording_->sampler.take(period);
      });
}

void LiveRun::advanceTo(double time, FrameSink& sink)
{
  observePeriods(statisticsWanted(sink));
  try
  {
    simulation_.advanceTo(std::min(time, nextTime()));
  }
  catch (const StallError& error)
  {
    stop_reason_ = error.what();
  }
  takeDue(sink);
}

void LiveRun::takeDue(FrameSink& sink)
{
  sampler_.takeDue(simulation_, sink);
  if (recording_)
    recording_->sampler.takeDue(simulation_, recording_->sink);
  for (const CommandFrame& command : std::exchange(opening_, {}))
    show(command, sink);
}

void LiveRun::takeAll(FrameSink& sink)
{
  sampler_.takeLast(simulation_, sink);
  if (recording_)
    recording_->sampler.takeLast(simulation_, recording_->sink);
}

StatisticsFrame LiveRun::statistics() const
{
  StatisticsWindow window = periods_observed_ ? sampler_.window() : StatisticsWindow();
  window.moveTo(simulation_);
  return makeStatisticsFrame(simulation_, window);
}

void LiveRun::applyCommand(CommandFrame command, FrameSink& sink)
{
  command.time = time();
  apply(command, simulation_);
  show(command, sink);
}

void LiveRun::show(const CommandFrame& command, FrameSink& sink)
{
  sink.take(command);
  if (recording_)
    recording_->sink.take(command);
}

}  // namespace ratchet_sieve
