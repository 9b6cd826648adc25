#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// What the programs of the comparison in C++ have in common. Each is given a file that runs.py writes: the
/// mixture of Fig. 8 at theta = 0, where its disks start, and for how long it runs. Each writes samples, from
/// which samples.py tells drifts and overlaps, and prints one line of JSON.
namespace ratchet_sieve::peers
{

constexpr double TIDY = 0.001;        ///< interval at which disks are moved to the other end [s]
constexpr double LOST_DEPTH = 0.010;  ///< A disk so far below the feet has fallen through the base [m].

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
    return {{"version", version},
            {"wall_seconds", wall_},
            {"processor_seconds", processor_},
            {"collisions", collisions},
            {"lost", lost}};
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

struct Disk
{
  double x, y;  ///< start, at rest
  double radius, mass;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Disk, x, y, radius, mass)

/// The scene in the words of the other programs, by mixture_of() of runs.py.
struct Mixture
{
  /// Of the base [m].
  double displacement(double time) const { return amplitude * std::sin(omega * time); }
  double velocity(double time) const { return amplitude * omega * std::cos(omega * time); }

  double width, clear_height, amplitude, omega, gravity;
  double restitution, friction;  ///< of every contact
  std::vector<Point> outline;    ///< foot, apex, foot, ... from left to right, some teeth beyond either end
  std::vector<Disk> disks;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Mixture, width, clear_height, amplitude, omega, gravity, restitution,
                                   friction, outline, disks)

/// Runs the scene in a time-stepping program without a periodic boundary. World: step(k) executes step k, to
/// (k + 1) dt; place(i) a disk's centre [m]; moveTo(i, point, stop) moves it, at rest if `stop`; contacts()
/// number of contacts begun since the start.
template <class World>
class SteppedRun
{
public:
  SteppedRun(World& world, const Mixture& mixture, const nlohmann::json& run)
      : world_(world),
        mixture_(mixture),
        run_(run),
        step_(run["step"]),
        samples_(run),
        wraps_(mixture.disks.size())
  {
  }

  /// @param version of the program
  void run(const std::string& version)
  {
    const auto steps = [&](const char* name) { return std::llround(run_[name].get<double>() / step_); };
    const auto settled = steps("settle");
    const auto end = settled + steps("duration");
    const auto tidy = std::max(1LL, std::llround(TIDY / step_));
    const auto look = std::max(1LL, steps("look"));
    if (settled == 0)
      lookAt(0);
    clock_.start();
    for (long long k = 0; k < end;)
    {
      world_.step(k);
      ++k;
      if (k % tidy == 0)
        takeBackWhatLeft();
      if (k < settled || (k != settled && k % look != 0 && k != end))
        continue;
      clock_.stop();
      if (k == settled)
      {
        contacts_at_start_ = world_.contacts();
        lost_ = 0;
        clock_.clear();
      }
      lookAt(k);
      clock_.start();
    }
    clock_.stop();
    std::printf("%s\n",
                clock_.outcome(version, world_.contacts() - contacts_at_start_, lost_).dump().c_str());
  }

private:
  void lookAt(long long k)
  {
    std::vector<Point> places(wraps_.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      places[i] = world_.place(i);
      places[i].x += wraps_[i] * mixture_.width;
    }
    const double time = static_cast<double>(k) * step_;
    samples_.write(time, mixture_.displacement(time), places);
  }

  void takeBackWhatLeft()
  {
    const double width = mixture_.width;
    for (std::size_t i = 0; i < wraps_.size(); ++i)
    {
      const Point at = world_.place(i);
      const double turns = std::floor(at.x / width);
      if (turns != 0.0)
      {
        world_.moveTo(i, {at.x - turns * width, at.y}, false);
        wraps_[i] += turns;
      }
      if (at.y < -mixture_.amplitude - LOST_DEPTH)
      {
        ++lost_;
        world_.moveTo(i, {at.x - turns * width, clearHeight(i, at.x - turns * width)}, true);
      }
    }
  }

  /// A height above every disk of the column at x.
  double clearHeight(std::size_t i, double x) const
  {
    double y = mixture_.clear_height;
    for (std::size_t j = 0; j < wraps_.size(); ++j)
    {
      const double reach = mixture_.disks[i].radius + mixture_.disks[j].radius;
      if (j != i && std::abs(world_.place(j).x - x) < reach)
        y = std::max(y, world_.place(j).y + reach);
    }
    return y;
  }

  World& world_;
  const Mixture& mixture_;
  const nlohmann::json& run_;
  double step_;
  Samples samples_;
  StopWatch clock_;
  std::vector<double> wraps_;  ///< widths by which a disk was moved
  std::uint64_t contacts_at_start_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace ratchet_sieve::peers
