#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mixture_scene.h"
#include "model/base_shape.h"

namespace ratchet_sieve::peers
{

/// The options of every program of the comparison.
struct RunOptions
{
  std::uint64_t seed = 1;
  double settle = 2.0;    ///< simulated before the measurement [s]
  double duration = 8.0;  ///< simulated during the measurement [s]
  double step = 1e-4;     ///< integration step of the time-stepping programs [s]
};

/// Sums the time between start() and stop().
class StopWatch
{
public:
  void start()
  {
    wall_start_ = Clock::now();
    processor_start_ = std::clock();
  }
  void stop()
  {
    wall_ += std::chrono::duration<double>(Clock::now() - wall_start_).count();
    processor_ += static_cast<double>(std::clock() - processor_start_) / CLOCKS_PER_SEC;
  }
  void clear() { wall_ = processor_ = 0.0; }
  double wallSeconds() const { return wall_; }

  /// Less than the wall time if other programs use the processor.
  double processorSeconds() const { return processor_; }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point wall_start_;
  std::clock_t processor_start_ = 0;
  double wall_ = 0.0;
  double processor_ = 0.0;
};

/// Measurements at fixed times with the clock stopped, the same for every program.
class Watch
{
public:
  Watch(const SceneDefinition& scene, std::vector<std::uint32_t> species);

  /// Takes a sample. @param x unwrapped, @param place wrapped, both in the order of the disks
  void look(double time, double base_y, const std::vector<double>& x, const std::vector<Point>& place);

  /// Forgets earlier samples: the end of the settling. Mean velocities are measured from `x` on.
  void restart(double time, const std::vector<double>& x);

  /// Mean velocity of each species over each block of time [m/s].
  nlohmann::json blocks() const { return blocks_; }
  double largestOverlap() const { return largest_overlap_; }
  double largestBaseOverlap() const { return largest_base_overlap_; }
  std::size_t mostBehindBase() const { return most_behind_base_; }

private:
  void endBlock(double time, const std::vector<double>& x);
  void audit(double base_y, const std::vector<Point>& place);

  std::vector<SpeciesDefinition> kinds_;
  std::vector<std::uint32_t> species_;
  BaseShape shape_;
  double block_start_ = 0.0;
  std::vector<double> x_at_block_start_;
  std::vector<std::vector<double>> blocks_;
  double largest_overlap_ = 0.0;
  double largest_base_overlap_ = 0.0;
  std::size_t most_behind_base_ = 0;
};

/// The sampling interval of a run. A block of the drift has several samples.
constexpr double LOOK = 0.01;   ///< [s]
constexpr double BLOCK = 0.5;   ///< [s]
constexpr double TIDY = 0.001;  ///< interval at which a stepping program moves disks to the other end [s]

/// The command line's options; `add` adds the program's own. Exits the program on --help or an error.
struct OwnOption
{
  std::string name;
  std::vector<std::string> values;  ///< the first is the default
  std::string help;
};
RunOptions readOptions(int argc, char** argv, const std::string& what, const std::vector<OwnOption>& own = {},
                       std::vector<std::string>* chosen = nullptr);

/// The output line of every program.
struct Outcome
{
  std::string program;
  std::string version;
  std::string configuration;
  std::optional<double> step = {};  ///< [s]
  double wall_seconds = 0.0;        ///< of the counted time
  double processor_seconds = 0.0;   ///< of the counted time
  double collisions = 0.0;
  std::size_t lost = 0;  ///< disks that fell through the base
};
void print(const Outcome& outcome, const RunOptions& options, const Watch& watch);

}  // namespace ratchet_sieve::peers
