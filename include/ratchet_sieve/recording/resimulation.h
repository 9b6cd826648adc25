#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Runs what was recorded once more, from its scene, its seed and its commands, and compares every frame
/// with what comes out now, bit for bit. Takes the frames in the order of time.
///
/// What depends on the clock on the wall or on how often someone subscribed is not compared: the real-time
/// factor, and the largest overlap.
class Resimulation : public FrameSink
{
public:
  /// @param progress shown the run after each instant; may be empty
  explicit Resimulation(std::function<void(const Simulation&)> progress = {});
  ~Resimulation() override;

  /// A scene that stands there again, as at the start of each file of a recording that was split, is the
  /// same run. @throws SceneError or std::invalid_argument where what was recorded cannot be a run
  void take(const AnyFrame& frame) override;

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
    std::tuple<std::vector<BaseFrame>, std::vector<ParticleFrame>, std::vector<BinFrame>,
               std::vector<StatisticsFrame>>
        frames;
    std::vector<CommandFrame> commands;

    template <typename Frame>
    std::vector<Frame>& of()
    {
      if constexpr (std::is_same_v<Frame, CommandFrame>)
        return commands;
      else
        return std::get<std::vector<Frame>>(frames);
    }
    bool empty() const;
  };

  void begin(const SceneFrame& frame);
  void observePeriods();
  void comeTo(double time);
  void compareInstant();
  void compareAsThingsAre();
  template <typename Frame>
  Frame now() const;
  template <typename Frame>
  void dropSame(std::vector<Frame>& frames, const Frame& now);
  std::string describeDifference();

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
