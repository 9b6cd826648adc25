#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "bag_output.h"
#include "command_line.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/collision_file.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/trajectory_file.h"
#include "run_arguments.h"

namespace ratchet_sieve
{

/// The files that a run writes, all opened before it starts. One that fails is reported on standard error and
/// neither ends the run nor prevents the others.
class RunOutputs
{
public:
  /// @throws Refusal if a file cannot be written, or is an input or another output; nothing was written then
  /// @param feed_file of the scene; empty: none
  RunOutputs(const RunArguments& arguments, const std::string& feed_file);
  ~RunOutputs();

  void watch(Simulation& simulation, RunWatchers& watchers);

  /// Finishes the files, the summary first. @return whether all were written completely
  bool finish(const nlohmann::ordered_json& summary);

private:
  class GuardedSink;

  void open(const RunArguments& arguments);
  void add(FrameSink& sink, const FrameRates& rates, std::function<void()> finish);
  void writeSummary(const std::string& text);

  std::unique_ptr<AtomicFile> summary_;
  std::unique_ptr<CollisionFile> collisions_;
  std::unique_ptr<ExitFile> exits_;
  BagOutput bag_;
  std::unique_ptr<TrajectoryFile> trajectory_;
  std::unique_ptr<RunPage> page_;
  std::unique_ptr<AtomicFile> page_file_;
  std::vector<std::unique_ptr<GuardedSink>> sinks_;
  std::vector<FrameStream> streams_;
  nlohmann::ordered_json page_summary_;
  OutputAttempts attempts_{"sieve_run"};
};

}  // namespace ratchet_sieve
