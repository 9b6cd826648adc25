#include "ratchet_sieve/sweep/sweep_report.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/case.h"

namespace ratchet_sieve
{
namespace
{

using Seconds = std::chrono::duration<double>;

constexpr Seconds OF_A_CORNER(0.5);
constexpr std::size_t MOST_BITS = 4;  ///< 2^4 corners

/// The beginning of a run, or all of it.
struct ShortRun
{
  double cost = 0.0;  ///< processor time [s]
  double from = 0.0;  ///< simulated time until its end [s]
  bool whole = false;
  double at_start = 0.0;  ///< disks
  double left = 0.0;      ///< disks that have left
  double on_base = 0.0;   ///< disks at its end

  double fed() const { return left + on_base - at_start; }
  bool fills() const { return !whole && 2.0 * left < fed(); }
};

/// @param limit of wall time. Nothing if the pour takes longer.
std::optional<ShortRun> shortRun(const SceneDefinition& scene, Seconds limit)
{
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor_before = std::clock();
  RunWatchers watchers;
  watchers.stop_wanted = [=] { return std::chrono::steady_clock::now() - start > limit; };
  std::optional<Simulation> simulation = poured(scene, watchers.stop_wanted);
  if (!simulation)
    return std::nullopt;
  ShortRun run;
  run.whole = runToEnd(*simulation, watchers).end != RunEnd::STOPPED;
  run.from = simulation->time();
  run.at_start = static_cast<double>(disksAtStart(scene));
  for (const SpeciesBins& bins : simulation->bins())
  {
    run.left += static_cast<double>(bins.counted());
    run.on_base += static_cast<double>(bins.on_base);
  }
  run.cost = static_cast<double>(std::clock() - processor_before) / CLOCKS_PER_SEC;
  return run.from > 0.0 || run.whole ? std::optional(run) : std::nullopt;
}

/// Of the whole run, in proportion to disks times time. A base that fills up is taken to go on so. [s]
double wholeCost(const ShortRun& run, double duration)
{
  if (run.whole)
    return run.cost;
  const double rest = duration - run.from;
  const double growth = run.fills() ? (run.on_base - run.at_start) / run.from : 0.0;
  const double so_far = 0.5 * (run.at_start + run.on_base) * run.from;
  const double to_come = (run.on_base + 0.5 * growth * rest) * rest;
  return run.cost * (so_far > 0.0 ? 1.0 + to_come / so_far : duration / run.from);
}

std::string costText(double seconds)
{
  return seconds < 100.0 ? fmt::format("{:.2g} s", seconds) : durationText(seconds);
}

/// The settings at the corners of the grid, in the order of the sweep.
std::set<std::uint64_t> corners(const Sweep& sweep)
{
  std::set<std::uint64_t> points;
  const std::size_t bits = std::min(sweep.axes.size(), MOST_BITS);
  for (std::size_t ends = 0; ends < std::size_t{1} << bits; ++ends)
  {
    std::uint64_t point = 0;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
    {
      const bool last = (ends >> (i % MOST_BITS) & 1) != 0;
      point = point * sweep.axes[i].size + (last ? sweep.axes[i].size - 1 : 0);
    }
    points.insert(point);
  }
  return points;
}

std::string cornerText(const SceneDefinition& scene, const ShortRun& run, double cost)
{
  std::string text = "about " + costText(cost) + " a run";
  if (!run.fills())
    return text;
  const bool weak = peakLift(scene.base) < scene.gravity;
  return text + fmt::format(" if it goes on to fill up: of {:g} disks fed by {:.3g} s {:g} have left{}",
                            run.fed(), run.from, run.left, weak ? "; choked: the drive is below 1 g" : "");
}

}  // namespace

std::vector<std::string> costLines(const Sweep& sweep)
{
  std::vector<std::string> lines = {""};
  CaseBuilder builder(sweep);
  double sum = 0.0;
  double known = 0.0;
  for (const std::uint64_t point : corners(sweep))
  {
    const SceneDefinition scene = builder.at(point * sweep.seedCount()).scene;
    const std::string name = builder.settingName(point);
    const std::optional<ShortRun> run = shortRun(scene, OF_A_CORNER);
    const double cost = run ? wholeCost(*run, scene.duration) : 0.0;
    sum += cost;
    known += run ? 1.0 : 0.0;
    lines.push_back((name.empty() ? "" : name + ": ") +
                    (run ? cornerText(scene, *run, cost) : "unknown: it takes long to start"));
  }
  lines.front() = countText(sweep.sizeOfPart(), "case") + ": ";
  lines.front() += known > 0.0 ? "about " + costText(sum / known * static_cast<double>(sweep.sizeOfPart())) +
                                     " of processor time, by the corners of the grid"
                               : "an unknown time";
  return lines;
}

}  // namespace ratchet_sieve
