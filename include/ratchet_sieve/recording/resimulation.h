#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/recording/run.h"

namespace ratchet_sieve
{

/// Repeats a recorded run from its scene, its seed and its commands, and compares every frame bit for bit.
/// Takes the frames in the order of time.
///
/// Not compared: the real-time factor and the largest overlap, which depend on wall time and on the number of
/// subscribers.
class Resimulation : public FrameSink
{
public:
  /// @param progress called after each time; may be empty
  explicit Resimulation(std::function<void(const Simulation&)> progress = {});

  /// The same scene again, as at the start of each file of a split recording, continues the same run. @throws
  /// SceneError or std::invalid_argument if the recording cannot be a run
  void take(const AnyFrame& frame) override;

  /// Compares the last time. @throws std::invalid_argument if the recording has no frame to compare
  void finish();

  /// The first difference between the recording and the repeated run, in one line; nothing if they are equal.
  const std::optional<std::string>& difference() const { return difference_; }

  /// Of a difference: the recording lacks commands, which it was found by. It begins after its run did, or
  /// the base has other setpoints than the commands give it.
  bool lacksCommands() const { return lacks_commands_; }

  std::uint64_t frames() const { return frames_; }      ///< that were compared and equal
  std::uint64_t commands() const { return commands_; }  ///< that were applied
  double time() const;                                  ///< simulated time reached [s]
  const std::optional<SceneFrame>& scene() const { return scene_; }

private:
  using Recorded = std::variant<BaseFrame, ParticleFrame, BinFrame, StatisticsFrame, ObservedFrame>;

  void begin(const SceneFrame& frame);
  void observePeriods();
  void comeTo(double time);
  void compareInstant();
  void compareAsThingsAre();
  template <typename Frame>
  Frame now(const Frame& recorded);
  std::string describeDifference();
  bool setpointsDiffer();

  std::function<void(const Simulation&)> progress_;
  std::optional<SceneFrame> scene_;
  std::unique_ptr<Simulation> simulation_;
  std::optional<Run> run_;
  bool periods_observed_ = false;
  std::vector<PeriodRecord> periods_;  ///< since the last statistics
  StatisticsWindow window_;

  /// All recorded frames and commands of one time. The recording does not contain the order of frames and
  /// commands of the same time. So a frame is accepted if it matches the state after any number of these
  /// commands.
  double instant_ = 0.0;
  std::vector<Recorded> recorded_;
  std::vector<CommandFrame> commands_then_;

  std::optional<double> first_;  ///< time of the first frame but for the scene [s]
  double widest_ = 0.0;          ///< time between two frames at most [s]
  std::optional<std::string> difference_;
  double differs_at_ = 0.0;  ///< [s]
  bool lacks_commands_ = false;
  std::uint64_t frames_ = 0;
  std::uint64_t commands_ = 0;
};

}  // namespace ratchet_sieve
