#include "ratchet_sieve/ros/live_run.h"

#include <algorithm>

#include "shifted_sink.h"

namespace ratchet_sieve
{

LiveRun::LiveRun(const SceneDefinition& scene, const FrameRates& rates, const SlewRates& slew_rates,
                 double start_time, double end_time)
    : simulation_(scene), sampler_(rates, 0.0), start_time_(start_time), end_time_(end_time)
{
  simulation_.setSlewRates(slew_rates);
}

double LiveRun::nextTime() const
{
  const double next = std::min(sampler_.nextTime(), end_time_ - start_time_);
  return recording_ ? std::min(next, recording_->sampler.nextTime()) : next;
}

void LiveRun::advanceTo(double elapsed, FrameSink& sink)
{
  try
  {
    simulation_.advanceTo(std::min(elapsed, nextTime()));
  }
  catch (const StallError& error)
  {
    stop_reason_ = error.what();
  }
  takeDue(sink);
}

void LiveRun::takeDue(FrameSink& sink)
{
  ShiftedSink shifted(sink, start_time_);
  sampler_.takeDue(simulation_, shifted);
  if (!recording_)
    return;
  ShiftedSink recorder(recording_->sink, start_time_);
  recording_->sampler.takeDue(simulation_, recorder);
}

void LiveRun::takeAll(FrameSink& sink)
{
  ShiftedSink shifted(sink, start_time_);
  sampler_.takeLast(simulation_, shifted);
  if (!recording_)
    return;
  ShiftedSink recorder(recording_->sink, start_time_);
  recording_->sampler.takeLast(simulation_, recorder);
}

template <typename Frame>
Frame LiveRun::published(Frame frame) const
{
  frame.time += start_time_;
  return frame;
}

ParticleFrame LiveRun::particles() const
{
  return published(makeParticleFrame(simulation_));
}

BinFrame LiveRun::bins() const
{
  return published(makeBinFrame(simulation_));
}

BaseFrame LiveRun::base() const
{
  return published(makeBaseFrame(simulation_));
}

StatisticsFrame LiveRun::statistics() const
{
  return published(makeStatisticsFrame(simulation_, nullptr, 0.0));
}

}  // namespace ratchet_sieve
