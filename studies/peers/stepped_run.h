#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "mixture_run.h"

namespace ratchet_sieve::peers
{

constexpr double TIDY = 0.001;        ///< interval at which disks are moved to the other end [s]
constexpr double LOST_DEPTH = 0.010;  ///< A disk so far below the feet has fallen through the base [m].

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
