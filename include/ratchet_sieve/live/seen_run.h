#pragma once

#include <deque>
#include <optional>
#include <string>

#include "ratchet_sieve/live/picture.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// A run as reconstructed from its topics: the last frames received, combined into pictures of one instant.
/// Each topic has a rate of its own and may be missing; time jumps back where a bag is played again or a
/// sieve is reset.
class SeenRun : public FrameSink
{
public:
  /// A scene that this program cannot read leaves the last one; sceneError() then says why.
  void take(const AnyFrame& frame) override;

  const std::optional<std::string>& sceneError() const { return scene_error_; }

  /// Time of the present picture [s]; nothing before a scene and a frame have been received.
  std::optional<double> time() const;

  /// The disks of the last frame, and the base at the same time: that of another time would overlap them.
  /// Without disks, the base of its last frame. Frames that do not fit the scene, which is possible while the
  /// topics change over to another, are left out. @pre time()
  Picture picture() const;

private:
  void see(const SceneFrame& frame);
  void see(const BaseFrame& frame);
  void see(const ParticleFrame& frame) { see(frame, particles_); }
  void see(const BinFrame& frame) { see(frame, bins_); }
  void see(const StatisticsFrame& frame) { see(frame, statistics_); }
  void see(const CommandFrame&) {}
  template <typename Frame>
  void see(const Frame& frame, std::optional<Frame>& last);
  void jumpBackTo(double time);
  bool fits(const ParticleFrame& frame) const;
  BaseFrame baseAt(double time) const;

  std::optional<SceneDefinition> scene_;
  std::optional<std::string> scene_error_;
  std::string yaml_;
  std::optional<ParticleFrame> particles_;
  std::optional<BinFrame> bins_;
  std::optional<StatisticsFrame> statistics_;
  std::deque<BaseFrame> bases_;  ///< the last ones, in the order of time
};

}  // namespace ratchet_sieve
