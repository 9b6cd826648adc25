#include "ratchet_sieve/live/journal.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/recording/certainty.h"
#include "ratchet_sieve/recording/choke.h"
#include "ratchet_sieve/recording/wall_warnings.h"
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
  lookAtEnergy(run.simulation());
  lookAtChoke(run.simulation());
  lookAtProgress(run);
  lookAtWalls(run.simulation());
  lookAtCertainty(run.simulation());
}

void Journal::lookAtProgress(const Run& run)
{
  const int tenths = tenthsOf(run);
  // After a reset the run is at its beginning again.
  if (tenths <= std::exchange(tenths_, tenths))
    return;
  const bool open = run.simulation().scene().boundary == Boundary::OPEN;
  log_.inform(fmt::format("{:3d} %: {:.1f} s, {}", 10 * tenths, run.time(),
                          open ? binsText(run.bins()) : driftText(run.simulation())));
}

void Journal::lookAtEnergy(const Simulation& simulation)
{
  const std::string text = simulation.energyText();
  if (!text.empty() && !energy_said_)
    log_.warn(text);
  energy_said_ = !text.empty();
}

void Journal::lookAtChoke(const Simulation& simulation)
{
  const std::string text = chokeText(simulation);
  if (!text.empty() && !choke_said_)
    log_.warn(text);
  // Once in a run: disks that leave for a while do not begin another.
  choke_said_ = (choke_said_ || !text.empty()) && simulation.time() > simulation.startTime();
}

void Journal::lookAtWalls(const Simulation& simulation)
{
  const std::uint64_t count = disksOverWalls(simulation);
  // After a reset the count is smaller.
  over_walls_said_ = std::min(over_walls_said_, count);
  if (count == 0 || count < 2 * over_walls_said_)
    return;
  over_walls_said_ = count;
  log_.warn(overWallsText(simulation));
}

void Journal::lookAtCertainty(const Simulation& simulation)
{
  if (!simulation.scene().accuracy.endsEarly())
    return;
  CertaintyState& state = certainty_;
  if (simulation.startTime() != state.start || simulation.time() < state.last_time)
    state = {};
  state.start = simulation.startTime();
  state.last_time = simulation.time();
  if (state.said || (state.next && state.last_time < *state.next))
    return;
  const bool due = std::exchange(state.next, LookTimes(simulation).next()).has_value();
  if (!due || !*certaintyOf(simulation).reached())
    return;
  state.said = true;
  log_.inform(fmt::format("at {:g} s the requested accuracy is reached; the run continues", state.last_time));
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
