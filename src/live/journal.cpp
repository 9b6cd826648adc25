#include "ratchet_sieve/live/journal.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/recording/certainty.h"
#include "ratchet_sieve/recording/run_warnings.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{
constexpr double MM_PER_M = 1e3;

std::uint64_t total(const BinFrame& frame, std::uint64_t SpeciesBins::*bin)
{
  return std::accumulate(frame.bins.begin(), frame.bins.end(), std::uint64_t{0},
                         [bin](std::uint64_t sum, const SpeciesBins& bins) { return sum + bins.*bin; });
}

std::string binsText(const BinFrame& frame)
{
  std::string text =
      fmt::format("{} left, {} right, {} on the base", countText(total(frame, &SpeciesBins::left), "disk"),
                  total(frame, &SpeciesBins::right), total(frame, &SpeciesBins::on_base));
  if (frame.quality)
    text += fmt::format(", Q = {:.3f}", *frame.quality);
  return text;
}

/// Where no disk can leave, progress is shown by the mean velocity of each species.
std::string driftText(const Simulation& simulation)
{
  const std::vector<SpeciesMeans> means = simulation.means();
  std::string text;
  for (std::size_t k = 0; k < means.size(); ++k)
    if (means[k].mean_vx)
      text += fmt::format("{} {} {:+.2f}", text.empty() ? "<V_x>" : ",",
                          shownText(simulation.scene().species[k].name), MM_PER_M * *means[k].mean_vx);
  return text.empty() ? "<V_x> is not counted yet" : text + " mm/s";
}

/// A run of no duration is at its end from the start.
int tenthsOf(const Run& run)
{
  const double duration = run.endTime() - run.startTime();
  return duration > 0.0 ? static_cast<int>(10.0 * (run.time() - run.startTime()) / duration) : 10;
}
}  // namespace

void Journal::look(const Run& run)
{
  // After a reset another run begins.
  if (run.startTime() != said_.start || run.time() < said_.last_time)
    said_ = {};
  said_.start = run.startTime();
  said_.last_time = run.time();
  if (!said_.energy)
    said_.energy = warn(energyText(run.simulation()));
  if (!said_.choke)
    said_.choke = warn(chokeText(run.simulation()));
  lookAtProgress(run);
  lookAtWalls(run.simulation());
  lookAtCertainty(run.simulation());
}

void Journal::lookAtProgress(const Run& run)
{
  const int tenths = tenthsOf(run);
  if (tenths <= said_.tenths)
    return;
  said_.tenths = tenths;
  const bool open = run.simulation().scene().boundary == Boundary::OPEN;
  log_.inform(fmt::format("{:3d} %: {:.1f} s, {}", 10 * tenths, run.time(),
                          open ? binsText(run.now<BinFrame>()) : driftText(run.simulation())));
}

bool Journal::warn(const std::string& text)
{
  if (!text.empty())
    log_.warn(text);
  return !text.empty();
}

void Journal::lookAtWalls(const Simulation& simulation)
{
  const std::uint64_t count = disksOverWalls(simulation);
  if (count == 0 || count < 2 * said_.over_walls)
    return;
  said_.over_walls = count;
  log_.warn(overWallsText(simulation));
}

void Journal::lookAtCertainty(const Simulation& simulation)
{
  if (!simulation.scene().accuracy.endsEarly() || said_.certainty ||
      (said_.next_certainty && simulation.time() < *said_.next_certainty))
    return;
  const double next = lookFrom(simulation, simulation.time());
  const bool due = std::exchange(said_.next_certainty, next).has_value();
  if (!due || !*certaintyOf(simulation).reached())
    return;
  said_.certainty = true;
  log_.inform(
      fmt::format("at {:g} s the requested accuracy is reached; the run continues", simulation.time()));
}

void Journal::pouring(std::size_t poured, std::size_t of, Clock::time_point now)
{
  // The count grows during one pour; if it does not, a new pour has begun.
  if (poured <= std::exchange(poured_, poured))
    next_pour_line_ = now + POUR_PERIOD;
  if (now < next_pour_line_)
    return;
  next_pour_line_ = now + POUR_PERIOD;
  log_.inform(fmt::format("{} of {} poured", poured, countText(of, "disk")));
}

}  // namespace ratchet_sieve
