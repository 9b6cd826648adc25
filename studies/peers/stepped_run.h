#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "mixture_run.h"

namespace ratchet_sieve::peers
{

constexpr double TIDY = 0.001;        ///< interval at which disks are moved to the other end [s]
constexpr double LOST_DEPTH = 0.010;  ///< A disk so far below the feet has fallen through the base [m].
constexpr int EXTRA_TEETH = 2;        ///< at either end, for disks that have passed it and are not yet moved
constexpr double TWO_PI = 6.283185307179586;

struct Disk
{
  Point start;  ///< at rest
  double radius;
  double mass;
};

/// The scene, in the words of the other programs.
struct Mixture
{
  explicit Mixture(const nlohmann::json& run)
  {
    const nlohmann::json& scene = run["scene"];
    base = scene["base"];
    teeth = base["teeth"];
    tooth_width = base["tooth_width"];
    tooth_height = base["tooth_height"];
    amplitude = base["amplitude"];
    omega = TWO_PI * base["frequency"].get<double>();
    gravity = scene["gravity"];
    drop_height = scene["pour"]["drop_height"];
    restitution = scene["species"][0]["restitution"];
    friction = scene["species"][0]["friction"];
    for (const nlohmann::json& disk : run["disks"])
    {
      const nlohmann::json& species = scene["species"][disk[0].get<std::size_t>()];
      disks.push_back({{disk[1], disk[2]}, species["radius"], species["mass"]});
    }
  }

  double width() const { return teeth * tooth_width; }

  /// Of the base [m].
  double displacement(double time) const { return amplitude * std::sin(omega * time); }
  double velocity(double time) const { return amplitude * omega * std::cos(omega * time); }

  /// Foot, apex, foot, ... from left to right, EXTRA_TEETH beyond either end.
  std::vector<Point> outline() const
  {
    const double asymmetry = base["asymmetry"];
    std::vector<Point> points;
    for (int tooth = -EXTRA_TEETH; tooth < teeth + EXTRA_TEETH; ++tooth)
    {
      points.push_back({tooth * tooth_width, 0.0});
      points.push_back({(tooth + asymmetry) * tooth_width, tooth_height});
    }
    points.push_back({(teeth + EXTRA_TEETH) * tooth_width, 0.0});
    return points;
  }

  nlohmann::json base;
  int teeth;
  double tooth_width, tooth_height, amplitude, omega, gravity, drop_height;
  double restitution, friction;  ///< of every contact
  std::vector<Disk> disks;
};

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
      places[i].x += wraps_[i] * mixture_.width();
    }
    const double time = static_cast<double>(k) * step_;
    samples_.write(time, mixture_.displacement(time), places);
  }

  void takeBackWhatLeft()
  {
    const double width = mixture_.width();
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
    double y = mixture_.tooth_height + mixture_.amplitude + mixture_.drop_height;
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
