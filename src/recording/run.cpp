#include "ratchet_sieve/recording/run.h"

#include <algorithm>
#include <utility>

#include "ratchet_sieve/recording/commands.h"

namespace ratchet_sieve
{

Run::Run(Simulation& simulation, double end_time, FrameSampler::WallClock wall_clock)
    : simulation_(simulation), end_time_(end_time), wall_clock_(std::move(wall_clock))
{
}

Run::Run(Simulation&& simulation, double end_time, FrameSampler::WallClock wall_clock)
    : kept_(std::make_unique<Simulation>(std::move(simulation))),
      simulation_(*kept_),
      end_time_(end_time),
      wall_clock_(std::move(wall_clock))
{
}

Run::~Run()
{
  if (periods_observed_)
    simulation_.observePeriods({});
}

void Run::add(FrameSink& sink, const FrameRates& rates)
{
  streams_.push_back({sink, {rates, simulation_.startTime(), wall_clock_}});
  streams_.back().sampler.setUnderWay(under_way_);
}

void Run::open(std::vector<CommandFrame> commands)
{
  for (CommandFrame& command : commands)
  {
    command.time = simulation_.startTime();
    apply(command, simulation_);
  }
  opening_ = std::move(commands);
}

void Run::setUnderWay(bool under_way)
{
  under_way_ = under_way;
  for (Stream& stream : streams_)
    stream.sampler.setUnderWay(under_way);
}

double Run::nextTime() const
{
  double next = end_time_;
  for (const Stream& stream : streams_)
    next = std::min(next, stream.sampler.nextTime());
  return next;
}

bool Run::statisticsWanted() const
{
  return statistics_kept_ ||
         std::any_of(streams_.begin(), streams_.end(),
                     [](const Stream& stream) { return stream.sink.wants(FrameKind::STATISTICS); });
}

/// Each observed period evaluates the velocities of all disks eight times.
void Run::observePeriods()
{
  const bool observe = statisticsWanted();
  if (observe == periods_observed_)
    return;
  periods_observed_ = observe;
  if (!observe)
    return simulation_.observePeriods({});
  for (Stream& stream : streams_)
    stream.sampler.restartWindow(simulation_);
  simulation_.observePeriods(
      [this](const PeriodRecord& period)
      {
        for (Stream& stream : streams_)
          stream.sampler.take(period);
      });
}

void Run::advanceTo(double time)
{
  observePeriods();
  try
  {
    simulation_.advanceTo(std::min(time, nextTime()));
  }
  catch (const StallError& error)
  {
    stop_reason_ = error.what();
  }
  takeDue();
}

void Run::takeDue()
{
  for (Stream& stream : streams_)
    stream.sampler.takeDue(simulation_, stream.sink);
  for (const CommandFrame& command : std::exchange(opening_, {}))
    show(command);
}

void Run::takeAll()
{
  for (Stream& stream : streams_)
    stream.sampler.takeLast(simulation_, stream.sink);
}

void Run::show(const AnyFrame& frame)
{
  for (const Stream& stream : streams_)
    stream.sink.take(frame);
}

void Run::applyCommand(CommandFrame command)
{
  command.time = time();
  apply(command, simulation_);
  show(command);
}

StatisticsFrame Run::statistics() const
{
  StatisticsWindow window;
  if (periods_observed_ && !streams_.empty())
    window = streams_.front().sampler.window();
  window.moveTo(simulation_);
  return makeStatisticsFrame(simulation_, window);
}

}  // namespace ratchet_sieve
