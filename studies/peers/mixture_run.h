#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// What the programs of the comparison have in common. Each is given a file that runs.py writes: the mixture
/// of Fig. 8 at theta = 0, where its disks start, and for how long it runs. Each writes samples, from which
/// samples.py tells drifts and overlaps, and prints one line of JSON.
namespace ratchet_sieve::peers
{

#ifdef __clang__
constexpr const char* COMPILER = __VERSION__;
#else
constexpr const char* COMPILER = "GCC " __VERSION__;
#endif

struct Point
{
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Point, x, y)

inline nlohmann::json readRun(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fprintf(stderr, "%s: needs the file of a run, which compare_peers.py writes\n", argv[0]);
    std::exit(2);
  }
  std::ifstream file(argv[1]);
  return nlohmann::json::parse(file);
}

/// Sums the time between start() and stop(). Processor time is less than wall time if other programs use the
/// processor.
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

  /// What a program prints of a run. @param lost disks that fell through the base
  nlohmann::json outcome(const std::string& version, std::uint64_t collisions, std::size_t lost) const
  {
    return {{"version", version},       {"compiler", COMPILER},
            {"wall_seconds", wall_},    {"processor_seconds", processor_},
            {"collisions", collisions}, {"lost", lost}};
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point wall_start_;
  std::clock_t processor_start_ = 0;
  double wall_ = 0.0;
  double processor_ = 0.0;
};

/// Samples of a run, as doubles: its time [s], the base's displacement [m], and of each disk x, as if the
/// base went on, and y [m].
class Samples
{
public:
  explicit Samples(const nlohmann::json& run) : file_(run["samples"].get<std::string>(), std::ios::binary) {}

  void write(double time, double base_y, const std::vector<Point>& places)
  {
    writeDoubles(&time, 1);
    writeDoubles(&base_y, 1);
    for (const Point& place : places)
      writeDoubles(&place.x, 2);
  }

private:
  void writeDoubles(const double* values, std::size_t count)
  {
    file_.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(double)));
  }

  std::ofstream file_;
};

}  // namespace ratchet_sieve::peers
