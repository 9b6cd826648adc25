#include "ratchet_sieve/ros/progress_log.h"

#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace ratchet_sieve
{
namespace
{
std::uint64_t total(const BinFrame& frame, std::uint64_t SpeciesBins::*bin)
{
  return std::accumulate(frame.bins.begin(), frame.bins.end(), std::uint64_t{0},
                         [bin](std::uint64_t sum, const SpeciesBins& bins) { return sum + bins.*bin; });
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
  const BinFrame frame = run.bins();
  std::string line = fmt::format("{:3d} %: {:.1f} s, {} disks left, {} right, {} on the base", 10 * tenths,
                                 run.time(), total(frame, &SpeciesBins::left),
                                 total(frame, &SpeciesBins::right), total(frame, &SpeciesBins::on_base));
  if (frame.quality)
    line += fmt::format(", Q = {:.3f}", *frame.quality);
  return line;
}

}  // namespace ratchet_sieve
