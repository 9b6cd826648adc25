#pragma once

#include <deque>
#include <optional>
#include <string>

#include "ratchet_sieve/live/picture.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// A run as its topics show it: the last frames that came, put together to pictures of one instant. Topics
/// come one by one, each at its own rate, some perhaps not at all; and time may leap back, where a bag is
/// played again or a sieve is reset.
class SeenRun : public FrameSink
{
public:
  /// A scene that this program cannot read leaves the last one; sceneError() then says why.
  void take(const AnyFrame& frame) override;

  const std::optional<std::string>& sceneError() const { return scene_error_; }

  /// Time of the picture that there is now [s]; nothing before a scene and a frame have come.
  std::optional<double> time() const;

  /// The disks as they were seen last, and the base at their very time: an earlier or a later one would
  /// stand in the disks. Without disks, the base as it was seen last. Call only where time() is something.
  /// Frames that are no part of the scene, as it can be while topics change over to another, are left out.
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
  void leapTo(double time);
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
