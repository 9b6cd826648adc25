#pragma once

#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/recording/same_bits.h"

namespace ratchet_sieve
{

/// Without the real-time factor, which topics and recording measure separately.
inline bool sameButForSpeed(StatisticsFrame a, StatisticsFrame b)
{
  a.real_time_factor = b.real_time_factor = 0.0;
  return sameBits(a, b);
}

/// Keeps every frame.
class CollectingSink : public FrameSink
{
public:
  void take(const AnyFrame& any) override
  {
    any.visit([this](const auto& frame) { keep(frame); });
  }

  std::vector<SceneFrame> scenes;
  std::vector<ParticleFrame> particles;
  std::vector<BinFrame> bins;
  std::vector<BaseFrame> bases;
  std::vector<StatisticsFrame> statistics;
  std::vector<ObservedFrame> observed;
  std::vector<CommandFrame> commands;

private:
  void keep(const SceneFrame& frame) { scenes.push_back(frame); }
  void keep(const ParticleFrame& frame) { particles.push_back(frame); }
  void keep(const BinFrame& frame) { bins.push_back(frame); }
  void keep(const BaseFrame& frame) { bases.push_back(frame); }
  void keep(const StatisticsFrame& frame) { statistics.push_back(frame); }
  void keep(const ObservedFrame& frame) { observed.push_back(frame); }
  void keep(const CommandFrame& frame) { commands.push_back(frame); }
};

}  // namespace ratchet_sieve
