#include "ratchet_sieve/recording/frame_sampler.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ratchet_sieve
{

FrameSampler::FrameSampler(const FrameRates& rates, double start_time, WallClock wall_clock)
    : start_time_(start_time), wall_clock_(std::move(wall_clock)), last_statistics_wall_(wall_clock_())
{
  particles_.rate = rates.particles;
  bins_.rate = rates.bins;
  base_.rate = rates.base;
  statistics_.rate = rates.statistics;
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
  return std::min({dueTime(particles_), dueTime(bins_), dueTime(base_), dueTime(statistics_)});
}

bool FrameSampler::passIfDue(Stream& stream, double time) const
{
  if (dueTime(stream) > time)
    return false;
  // A run may be taken up long after the times began: no step for each that was missed.
  const double missed = (time - start_time_) * std::max(stream.rate, 0.0) - 1.0;
  if (missed > static_cast<double>(stream.next_index))
    stream.next_index = static_cast<std::uint64_t>(missed);
  while (dueTime(stream) <= time)
    ++stream.next_index;
  stream.last_time = time;
  return true;
}

void FrameSampler::takeBase(const Simulation& simulation, FrameSink& sink)
{
  if (sink.wants(FrameKind::BASE))
    sink.take(makeBaseFrame(simulation));
}

void FrameSampler::takeParticles(const Simulation& simulation, FrameSink& sink)
{
  if (!sink.wants(FrameKind::PARTICLES))
    return;
  simulation.disks(particle_frame_.disks);
  particle_frame_.time = simulation.time();
  sink.take(particle_frame_);
}

void FrameSampler::takeBins(const Simulation& simulation, FrameSink& sink)
{
  if (sink.wants(FrameKind::BINS))
    sink.take(makeBinFrame(simulation));
}

void FrameSampler::takeStatistics(const Simulation& simulation, FrameSink& sink)
{
  // Also for a frame that nobody wants: those that follow are to be of the same window.
  window_.moveTo(simulation);
  if (!sink.wants(FrameKind::STATISTICS))
    return;
  StatisticsFrame frame = makeStatisticsFrame(simulation, window_);
  const auto now = wallTime();
  const double wall_seconds = std::chrono::duration<double>(now - last_statistics_wall_).count();
  if (last_statistics_ && frame.time > *last_statistics_ && wall_seconds > 0.0)
    frame.real_time_factor = (frame.time - *last_statistics_) / wall_seconds;
  last_statistics_ = frame.time;
  last_statistics_wall_ = now;
  sink.take(frame);
}

void FrameSampler::takeDue(const Simulation& simulation, FrameSink& sink)
{
  if (!scene_taken_)
    sink.take(makeSceneFrame(simulation));
  scene_taken_ = true;
  const double time = simulation.time();
  if (passIfDue(base_, time))
    takeBase(simulation, sink);
  if (passIfDue(particles_, time))
    takeParticles(simulation, sink);
  if (passIfDue(bins_, time))
    takeBins(simulation, sink);
  if (passIfDue(statistics_, time))
    takeStatistics(simulation, sink);
}

void FrameSampler::takeLast(const Simulation& simulation, FrameSink& sink)
{
  takeDue(simulation, sink);
  const double time = simulation.time();
  if (base_.last_time != time)
    takeBase(simulation, sink);
  if (particles_.last_time != time)
    takeParticles(simulation, sink);
  if (bins_.last_time != time)
    takeBins(simulation, sink);
  if (statistics_.last_time != time)
    takeStatistics(simulation, sink);
  for (Stream* stream : {&base_, &particles_, &bins_, &statistics_})
    stream->last_time = time;
}

}  // namespace ratchet_sieve
