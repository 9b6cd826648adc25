#include "ratchet_sieve/ros/live_run.h"

#include <algorithm>
#include <utility>

#include "ratchet_sieve/recording/commands.h"

namespace ratchet_sieve
{

LiveRun::LiveRun(const SceneDefinition& scene, const FrameRates& rates, std::vector<CommandFrame> opening,
                 double start_time, double end_time)
    : simulation_(scene, start_time),
      sampler_(rates, start_time),
      end_time_(end_time),
      opening_(std::move(opening))
{
  for (CommandFrame& command : opening_)
  {
    command.time = start_time;
    apply(command, simulation_);
  }
}

double LiveRun::nextTime() const
{
  return std::min(sampler_.nextTime(), end_time_);
}

void LiveRun::advanceTo(double time, FrameSink& sink)
{
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
  for (const CommandFrame& command : std::exchange(opening_, {}))
    sink.take(command);
}

void LiveRun::takeAll(FrameSink& sink)
{
  sampler_.takeLast(simulation_, sink);
}

void LiveRun::give(CommandFrame command, FrameSink& sink)
{
  command.time = time();
  apply(command, simulation_);
  sink.take(command);
}

}  // namespace ratchet_sieve
