#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Runs what was recorded once more, from its scene, its seed and its commands, and compares every frame
/// with what comes out now, bit for bit. Takes the frames in the order of time.
///
/// What depends on the clock on the wall or on how often someone looked is not compared: the real-time
/// factor, and the largest overlap.
class Resimulation : public FrameSink
{
public:
  /// @param progress shown the run after each instant; may be empty
  explicit Resimulation(std::function<void(const Simulation&)> progress = {});
  ~Resimulation() override;

  /// A scene that stands there again, as at the start of each file of a recording that was split, is the
  /// same run. All throw SceneError or std::invalid_argument where what was recorded cannot be a run.
  void take(const SceneFrame& frame) override;
  void take(const ParticleFrame& frame) override { add(frame, instant_.particles); }
  void take(const BinFrame& frame) override { add(frame, instant_.bins); }
  void take(const BaseFrame& frame) override { add(frame, instant_.bases); }
  void take(const StatisticsFrame& frame) override { add(frame, instant_.statistics); }
  void take(const CommandFrame& frame) override { add(frame, instant_.commands); }

  /// Compares what came last. @throws std::invalid_argument where nothing was recorded that can be compared
  void finish();

  /// Where the recording and the run first differ, in one line; nothing if they do not.
  const std::optional<std::string>& difference() const { return difference_; }

  std::uint64_t frames() const { return frames_; }      ///< compared, and the same
  std::uint64_t commands() const { return commands_; }  ///< given
  double time() const;                                  ///< how far the run has come [s]
  const std::optional<SceneFrame>& scene() const { return scene_; }

private:
  /// All that was recorded of one time. Which of the frames were taken before which of the commands is not
  /// recorded: each has to be as things were at some moment among them.
  struct Instant
  {
    double time = 0.0;
    std::vector<ParticleFrame> particles;
    std::vector<BinFrame> bins;
    std::vector<BaseFrame> bases;
    std::vector<StatisticsFrame> statistics;
    std::vector<CommandFrame> commands;

    bool empty() const;
  };

  template <typename Frame>
  void add(const Frame& frame, std::vector<Frame>& frames)
  {
    comeTo(frame.time);
    if (!difference_)
      frames.push_back(frame);
  }
  void observePeriods();
  void comeTo(double time);
  void compareInstant();
  void compareAsThingsAre();
  template <typename Frame>
  void dropSame(std::vector<Frame>& frames, const Frame& now);
  std::string describeDifference() const;

  std::function<void(const Simulation&)> progress_;
  std::optional<SceneFrame> scene_;
  std::unique_ptr<Simulation> simulation_;
  bool periods_observed_ = false;
  StatisticsWindow window_;
  Instant instant_;
  std::optional<std::string> difference_;
  std::uint64_t frames_ = 0;
  std::uint64_t commands_ = 0;
};

}  // namespace ratchet_sieve
