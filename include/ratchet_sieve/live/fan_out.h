#pragma once

#include <algorithm>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Hands every frame to several sinks, in the order in which they were added.
class FanOut : public FrameSink
{
public:
  /// @param sink outlives this
  void add(FrameSink& sink) { sinks_.push_back(&sink); }

  bool wants(FrameKind kind) const override
  {
    return std::any_of(sinks_.begin(), sinks_.end(),
                       [kind](const FrameSink* sink) { return sink->wants(kind); });
  }
  void take(const AnyFrame& frame) override
  {
    for (FrameSink* sink : sinks_)
      sink->take(frame);
  }

private:
  std::vector<FrameSink*> sinks_;
};

}  // namespace ratchet_sieve
