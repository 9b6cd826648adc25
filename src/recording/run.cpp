#include "ratchet_sieve/recording/run.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

namespace ratchet_sieve
{

FrameSampler::FrameSampler(const FrameRates& rates, double start_time, WallClock wall_clock)
    : start_time_(start_time), wall_clock_(std::move(wall_clock)), last_statistics_wall_(wall_clock_())
{
  forEachSampledType(
      [&](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        stream<Frame>().rate = rates.*describe(kindOf<Frame>()).rate;
      });
}

void FrameSampler::setUnderWay(bool under_way)
{
  if (under_way && stood_since_)
    last_statistics_wall_ += wall_clock_() - *stood_since_;
  if (!under_way)
    stood_since_ = wallTime();
  else
    stood_since_.reset();
}

std::chrono::steady_clock::time_point FrameSampler::wallTime() const
{
  return stood_since_ ? *stood_since_ : wall_clock_();
}

double FrameSampler::dueTime(const Stream& stream) const
{
  if (stream.next_index == 0)
    return start_time_;
  if (stream.rate <= 0.0)
    return std::numeric_limits<double>::infinity();
  return start_time_ + static_cast<double>(stream.next_index) / stream.rate;
}

double FrameSampler::nextTime() const
{
  double next = std::numeric_limits<double>::infinity();
  for (const FrameKindInfo& info : FRAME_LIST)
    if (info.rate != nullptr)
      next = std::min(next, dueTime(streams_[static_cast<std::size_t>(info.kind)]));
  return next;
}

bool FrameSampler::passIfDue(Stream& stream, double time) const
{
  if (dueTime(stream) > time)
    return false;
  // A run may be resumed long after start_time_: skip the missed frames at once.
  const double missed = (time - start_time_) * std::max(stream.rate, 0.0) - 1.0;
  if (missed > static_cast<double>(stream.next_index))
    stream.next_index = static_cast<std::uint64_t>(missed);
  while (dueTime(stream) <= time)
    ++stream.next_index;
  stream.last_time = time;
  return true;
}

double FrameSampler::realTimeFactorAt(double time)
{
  const auto now = wallTime();
  const double wall_seconds = std::chrono::duration<double>(now - last_statistics_wall_).count();
  const bool measured = last_statistics_ && time > *last_statistics_ && wall_seconds > 0.0;
  const double factor = measured ? (time - *last_statistics_) / wall_seconds : 0.0;
  last_statistics_ = time;
  last_statistics_wall_ = now;
  return factor;
}

template <typename Frame>
void FrameSampler::take(const Simulation& simulation, FrameSink& sink)
{
  // Also for an unwanted frame, so that later windows do not depend on the subscribers.
  if constexpr (std::is_same_v<Frame, StatisticsFrame>)
    window_.moveTo(simulation);
  if (!hasFrames<Frame>(simulation.scene()))
  {
    stream<Frame>().rate = 0.0;  // the run need not stop for it
    return;
  }
  if (!sink.wants(kindOf<Frame>()))
    return;
  if constexpr (std::is_same_v<Frame, ParticleFrame>)
  {
    makeParticleFrame(simulation, particle_frame_);
    sink.take(particle_frame_);
  }
  else
  {
    Frame frame = makeFrame<Frame>(simulation, window_);
    if constexpr (std::is_same_v<Frame, StatisticsFrame>)
      frame.real_time_factor = realTimeFactorAt(frame.time);
    sink.take(frame);
  }
}

void FrameSampler::takeDue(const Simulation& simulation, FrameSink& sink)
{
  if (!scene_taken_)
    sink.take(makeSceneFrame(simulation));
  scene_taken_ = true;
  forEachSampledType(
      [&](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        if (passIfDue(stream<Frame>(), simulation.time()))
          take<Frame>(simulation, sink);
      });
}

void FrameSampler::takeLast(const Simulation& simulation, FrameSink& sink)
{
  takeDue(simulation, sink);
  forEachSampledType(
      [&](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        if (stream<Frame>().last_time != simulation.time())
          take<Frame>(simulation, sink);
        stream<Frame>().last_time = simulation.time();
      });
}

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
