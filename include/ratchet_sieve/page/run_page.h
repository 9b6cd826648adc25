#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/analysis/run_analysis.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

class MotionRecord;

constexpr double BYTES_PER_MB = 1e6;

/// Sizes that a page may have [bytes]. The smallest holds the programs and tables of a page.
constexpr std::size_t SMALLEST_PAGE = 500'000;
constexpr std::size_t LARGEST_PAGE = 100'000'000;
constexpr std::size_t USUAL_PAGE = 3'000'000;

/// The run as one HTML file that needs nothing else: the motion of the machine, curves, results, and where
/// they come from. A sink for all frames of one run; a scene frame begins a new run.
class RunPage : public FrameSink
{
public:
  /// @param size which the file should not exceed [bytes]: the motion is thinned to it, see MotionRecord
  explicit RunPage(std::size_t size = USUAL_PAGE);
  ~RunPage() override;

  /// @throws SceneError, AnalysisError as RunAnalysis::take()
  void take(const AnyFrame& frame) override;

  const RunAnalysis& analysis() const { return analysis_; }

  /// Writes the page, and commits its file. @param title such as the name of the scene's file
  /// @param summary of the run: its warnings and steady state are shown, and the warnings that follow from
  /// the scene; may be empty @throws AnalysisError if no scene was taken @throws OutputError
  void write(AtomicFile&& file, const std::string& title,
             const nlohmann::ordered_json& summary = nlohmann::ordered_json::object()) const;

private:
  void begin(const SceneFrame& frame);

  std::size_t size_;
  RunAnalysis analysis_{false};
  Scene scene_;
  std::unique_ptr<MotionRecord> motion_;  ///< refers to the scene; nothing before one was taken
  std::vector<CommandFrame> commands_;
  std::size_t commands_taken_ = 0;
};

/// The rates of the frames of a page: disks and base at `rate` [1/s], see FrameRates.
FrameRates pageRates(double rate);

/// Enough for slow motion in which the shaking is seen [1/s].
constexpr double PAGE_RATE = 240.0;

}  // namespace ratchet_sieve
