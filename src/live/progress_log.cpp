#include "ratchet_sieve/live/progress_log.h"

#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/core/count_text.h"
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
int tenthsOf(const LiveRun& run)
{
  const double duration = run.endTime() - run.startTime();
  return duration > 0.0 ? static_cast<int>(10.0 * (run.time() - run.startTime()) / duration) : 10;
}
}  // namespace

std::optional<std::string> ProgressLog::line(const LiveRun& run)
{
  const int tenths = tenthsOf(run);
  // After a reset the run is at its beginning again.
  if (tenths <= std::exchange(tenths_, tenths))
    return std::nullopt;
  const bool open = run.simulation().scene().boundary == Boundary::OPEN;
  return fmt::format("{:3d} %: {:.1f} s, {}", 10 * tenths, run.time(),
                     open ? binsText(run.bins()) : driftText(run.simulation()));
}

}  // namespace ratchet_sieve
