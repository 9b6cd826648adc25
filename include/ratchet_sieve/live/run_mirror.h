#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// The input of a display at one instant, from the engine, from topics or from a bag. Kinds of frames that
/// were not recorded are empty.
struct Picture
{
  const SceneDefinition& scene;  ///< outlives this
  BaseFrame base;
  std::optional<BinFrame> bins;
  std::optional<ParticleFrame> particles;
  std::vector<SpeciesMeans> means = {};  ///< per species; empty if unknown
  std::string sieve = {};                ///< its name, to be shown; empty: none
};

/// Reconstructs a run from its topics: combines the last frames received into pictures of one instant. Each
/// topic has its own rate and may be missing. Time jumps back if a bag is played again or a sieve is reset.
class RunMirror : public FrameSink
{
public:
  /// If a scene cannot be parsed, the previous one stays, and sceneError() returns the reason.
  void take(const AnyFrame& frame) override;

  const std::optional<std::string>& sceneError() const { return scene_error_; }

  /// Time of the present picture [s]; nothing before a scene and a frame have been received.
  std::optional<double> time() const;

  /// The disks of the last frame, and the base at the same time, because a base of another time would overlap
  /// them. Without disks: the base of its last frame. Frames that do not fit the scene are left out; they
  /// occur while the topics change to another scene. @pre time()
  Picture picture() const;

private:
  void see(const SceneFrame& frame);
  void see(const BaseFrame& frame);
  void see(const ParticleFrame& frame) { see(frame, particles_); }
  void see(const BinFrame& frame) { see(frame, bins_); }
  void see(const StatisticsFrame& frame) { see(frame, statistics_); }
  void see(const ObservedFrame&) {}
  void see(const CommandFrame&) {}
  template <typename Frame>
  void see(const Frame& frame, std::optional<Frame>& last);
  void jumpBackTo(double time);
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
