#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mixture_run.h"

namespace ratchet_sieve::peers
{

/// A disk with its centre this far below the feet has fallen through the base and is put back on top [m].
constexpr double LOST_DEPTH = 0.010;

/// Runs the scene in a time-stepping program without a periodic boundary. World: step(k) executes step k, to
/// (k + 1) dt; place(i) a disk's centre [m]; moveTo(i, point, stop) moves it, at rest if `stop`; contacts()
/// number of contacts begun since the start.
template <class World>
class SteppedRun
{
public:
  SteppedRun(World& world, const SceneDefinition& scene, const RunOptions& options,
             const std::vector<DiskState>& start)
      : world_(world),
        scene_(scene),
        options_(options),
        watch_(scene, speciesOf(start)),
        wraps_(start.size(), 0.0)
  {
    for (const DiskState& disk : start)
      radii_.push_back(scene.species[disk.species].radius);
  }

  void run()
  {
    const double step = options_.step;
    const auto settled = std::llround(options_.settle / step);
    const auto end = settled + std::llround(options_.duration / step);
    const auto tidy = std::max(1LL, std::llround(TIDY / step));
    const auto look = std::max(1LL, std::llround(LOOK / step));
    restart(0);
    clock_.start();
    for (long long k = 0; k < end;)
    {
      world_.step(k);
      ++k;
      if (k % tidy == 0)
        takeBackWhatLeft();
      if (k != settled && k % look != 0 && k != end)
        continue;
      clock_.stop();
      lookAt(k);
      if (k == settled)
        restart(k);
      clock_.start();
    }
    clock_.stop();
  }

  void print(Outcome outcome) const
  {
    outcome.step = options_.step;
    outcome.wall_seconds = clock_.wallSeconds();
    outcome.processor_seconds = clock_.processorSeconds();
    outcome.collisions = static_cast<double>(world_.contacts() - contacts_at_start_);
    outcome.lost = lost_;
    peers::print(outcome, options_, watch_);
  }

private:
  static std::vector<std::uint32_t> speciesOf(const std::vector<DiskState>& start)
  {
    std::vector<std::uint32_t> species;
    for (const DiskState& disk : start)
      species.push_back(disk.species);
    return species;
  }

  void restart(long long k)
  {
    watch_.restart(static_cast<double>(k) * options_.step, unwrapped());
    contacts_at_start_ = world_.contacts();
    lost_ = 0;
    clock_.clear();
  }

  std::vector<double> unwrapped() const
  {
    std::vector<double> x(radii_.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = world_.place(i).x + wraps_[i] * scene_.base.width();
    return x;
  }

  void lookAt(long long k)
  {
    std::vector<Point> places(radii_.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      places[i] = world_.place(i);
    const double time = static_cast<double>(k) * options_.step;
    watch_.look(time, baseAt(scene_.base, time).y, unwrapped(), places);
  }

  void takeBackWhatLeft()
  {
    const double width = scene_.base.width();
    for (std::size_t i = 0; i < radii_.size(); ++i)
    {
      const Point at = world_.place(i);
      const double turns = std::floor(at.x / width);
      if (turns != 0.0)
      {
        world_.moveTo(i, {at.x - turns * width, at.y}, false);
        wraps_[i] += turns;
      }
      if (at.y < -scene_.base.amplitude - LOST_DEPTH)
      {
        ++lost_;
        world_.moveTo(i, {at.x - turns * width, clearHeight(i, at.x - turns * width)}, true);
      }
    }
  }

  /// A height above every disk of the column at x.
  double clearHeight(std::size_t i, double x) const
  {
    double y = scene_.base.tooth_height + scene_.base.amplitude + scene_.pour.drop_height;
    for (std::size_t j = 0; j < radii_.size(); ++j)
      if (j != i && std::abs(world_.place(j).x - x) < radii_[i] + radii_[j])
        y = std::max(y, world_.place(j).y + radii_[i] + radii_[j]);
    return y;
  }

  World& world_;
  const SceneDefinition& scene_;
  RunOptions options_;
  Watch watch_;
  StopWatch clock_;
  std::vector<double> radii_;
  std::vector<double> wraps_;  ///< widths by which a disk was moved
  std::uint64_t contacts_at_start_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace ratchet_sieve::peers
