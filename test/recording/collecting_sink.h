#pragma once

#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Keeps every frame.
class CollectingSink : public FrameSink
{
public:
  void take(const SceneFrame& frame) override { scenes.push_back(frame); }
  void take(const ParticleFrame& frame) override { particles.push_back(frame); }
  void take(const BinFrame& frame) override { bins.push_back(frame); }
  void take(const BaseFrame& frame) override { bases.push_back(frame); }
  void take(const StatisticsFrame& frame) override { statistics.push_back(frame); }
  void take(const CommandFrame& frame) override { commands.push_back(frame); }

  std::vector<SceneFrame> scenes;
  std::vector<ParticleFrame> particles;
  std::vector<BinFrame> bins;
  std::vector<BaseFrame> bases;
  std::vector<StatisticsFrame> statistics;
  std::vector<CommandFrame> commands;
};

}  // namespace ratchet_sieve
