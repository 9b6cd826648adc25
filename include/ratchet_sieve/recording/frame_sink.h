#pragma once

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// Takes a run's frames, in the order of time: a bag that is written, a set of topics, an analysis.
class FrameSink
{
public:
  virtual ~FrameSink() = default;

  /// Whether frames of a kind are of any use now. One that nobody wants need not be made.
  virtual bool wants(FrameKind) const { return true; }

  virtual void take(const SceneFrame& frame) = 0;
  virtual void take(const ParticleFrame& frame) = 0;
  virtual void take(const BinFrame& frame) = 0;
  virtual void take(const BaseFrame& frame) = 0;
  virtual void take(const StatisticsFrame& frame) = 0;
  virtual void take(const CommandFrame& frame) = 0;
};

}  // namespace ratchet_sieve
