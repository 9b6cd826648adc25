#pragma once

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Hands frames on with their times moved.
class ShiftedSink : public FrameSink
{
public:
  ShiftedSink(FrameSink& sink, double shift) : sink_(sink), shift_(shift) {}

  bool wants(FrameKind kind) const override { return sink_.wants(kind); }
  void take(const SceneFrame& frame) override { pass(frame); }
  void take(const ParticleFrame& frame) override { pass(frame); }
  void take(const BinFrame& frame) override { pass(frame); }
  void take(const BaseFrame& frame) override { pass(frame); }
  void take(const StatisticsFrame& frame) override { pass(frame); }

private:
  template <typename Frame>
  void pass(const Frame& frame)
  {
    if (shift_ == 0.0)
    {
      sink_.take(frame);
      return;
    }
    Frame shifted = frame;
    shifted.time += shift_;
    sink_.take(shifted);
  }

  FrameSink& sink_;
  double shift_;
};

}  // namespace ratchet_sieve
