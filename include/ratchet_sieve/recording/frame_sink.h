#pragma once

#include "ratchet_sieve/recording/frame_kinds.h"

namespace ratchet_sieve
{

/// Takes a run's frames, in the order of time: a bag that is written, a set of topics, an analysis.
class FrameSink
{
public:
  virtual ~FrameSink() = default;

  /// Whether frames of a kind are of any use now. One that is taken at a rate and that nobody wants need not
  /// be made.
  virtual bool wants(FrameKind) const { return true; }

  virtual void take(const AnyFrame& frame) = 0;
};

}  // namespace ratchet_sieve
