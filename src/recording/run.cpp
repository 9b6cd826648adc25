#include "ratchet_sieve/recording/run.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

namespace ratchet_sieve
{

Run::Run(Simulation& simulation, double end_time, WallClock wall_clock)
    : simulation_(simulation), end_time_(end_time), wall_clock_(std::move(wall_clock))
{
}

Run::Run(Simulation&& simulation, double end_time, WallClock wall_clock)
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
  Stream& stream = streams_.emplace_back(Stream{sink});
  forEachSampledType(
      [&](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        if (hasFrames<Frame>(simulation_.scene()))
          stream.of<Frame>().rate = rates.*describe(kindOf<Frame>()).rate;
      });
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
  if (under_way && stood_since_)
    stood_ += wall_clock_() - *std::exchange(stood_since_, std::nullopt);
  else if (!under_way && !stood_since_)
    stood_since_ = wall_clock_();
}

/// Without all pauses.
Run::Clock::time_point Run::wallTime() const
{
  return (stood_since_ ? *stood_since_ : wall_clock_()) - stood_;
}

double Run::dueTime(const Series& series) const
{
  if (series.next_index == 0)
    return startTime();
  if (series.rate <= 0.0)
    return std::numeric_limits<double>::infinity();
  return startTime() + static_cast<double>(series.next_index) / series.rate;
}

double Run::nextTime() const
{
  double next = end_time_;
  for (const Stream& stream : streams_)
    for (const FrameKindInfo& info : FRAME_LIST)
      if (info.rate != nullptr)
        next = std::min(next, dueTime(stream.series[static_cast<std::size_t>(info.kind)]));
  return next;
}

bool Run::passIfDue(Series& series) const
{
  if (dueTime(series) > time())
    return false;
  // A run may be resumed long after startTime(): skip the missed frames at once.
  const double missed = (time() - startTime()) * std::max(series.rate, 0.0) - 1.0;
  if (missed > static_cast<double>(series.next_index))
    series.next_index = static_cast<std::uint64_t>(missed);
  while (dueTime(series) <= time())
    ++series.next_index;
  series.last_time = time();
  return true;
}

void Run::measureSpeed(Stream& stream) const
{
  const Clock::time_point now = wallTime();
  const double wall_seconds = std::chrono::duration<double>(now - stream.last_statistics_wall).count();
  const bool measured = stream.last_statistics && time() > *stream.last_statistics && wall_seconds > 0.0;
  stream.real_time_factor = measured ? (time() - *stream.last_statistics) / wall_seconds : 0.0;
  stream.last_statistics = time();
  stream.last_statistics_wall = now;
}

template <typename Frame>
void Run::take(Stream& stream)
{
  // Also for an unwanted frame, so that later windows do not depend on the subscribers.
  if constexpr (std::is_same_v<Frame, StatisticsFrame>)
  {
    stream.window.moveTo(simulation_);
    measureSpeed(stream);
  }
  if (!hasFrames<Frame>(simulation_.scene()) || !stream.sink.wants(kindOf<Frame>()))
    return;
  Frame frame = makeFrame<Frame>(simulation_, stream.window);
  if constexpr (std::is_same_v<Frame, StatisticsFrame>)
    frame.real_time_factor = stream.real_time_factor;
  stream.sink.take(frame);
}

void Run::takeDue(Stream& stream)
{
  if (!std::exchange(stream.scene_taken, true))
    stream.sink.take(makeSceneFrame(simulation_));
  forEachSampledType(
      [&](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        if (passIfDue(stream.of<Frame>()))
          take<Frame>(stream);
      });
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
    stream.window.restart(simulation_);
  simulation_.observePeriods(
      [this](const PeriodRecord& period)
      {
        for (Stream& stream : streams_)
          stream.window.take(period);
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
    takeDue(stream);
  for (const CommandFrame& command : std::exchange(opening_, {}))
    show(command);
}

void Run::takeAll()
{
  for (Stream& stream : streams_)
  {
    takeDue(stream);
    forEachSampledType(
        [&](auto type)
        {
          using Frame = typename decltype(type)::Frame;
          if (stream.of<Frame>().last_time != time())
            take<Frame>(stream);
          stream.of<Frame>().last_time = time();
        });
  }
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

StatisticsWindow Run::presentWindow() const
{
  StatisticsWindow window;
  if (periods_observed_ && !streams_.empty())
    window = streams_.front().window;
  window.moveTo(simulation_);
  return window;
}

}  // namespace ratchet_sieve
