#pragma once

#include "ratchet_sieve/recording/frame_kinds.h"

namespace ratchet_sieve
{

/// Takes a run's frames in the order of time. Implemented by the bag writer, the topics and the analysis.
class FrameSink
{
public:
  virtual ~FrameSink() = default;

  /// Whether frames of a kind are needed at present. The sampler skips frames of a kind with a rate that is
  /// not wanted.
  virtual bool wants(FrameKind) const { return true; }

  virtual void take(const AnyFrame& frame) = 0;
};

}  // namespace ratchet_sieve
