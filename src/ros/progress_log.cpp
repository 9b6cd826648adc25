#include "ratchet_sieve/ros/progress_log.h"

#include <numeric>

#include <fmt/format.h>
#include <ros/console.h>

namespace ratchet_sieve
{
namespace
{
std::uint64_t total(const BinFrame& frame, std::uint64_t SpeciesBins::*bin)
{
  return std::accumulate(frame.bins.begin(), frame.bins.end(), std::uint64_t{0},
                         [bin](std::uint64_t sum, const SpeciesBins& bins) { return sum + bins.*bin; });
}
}  // namespace

void ProgressLog::update(const LiveRun& run)
{
  const int tenths = static_cast<int>(10.0 * run.time() / run.endTime());
  if (tenths > tenths_)
  {
    const BinFrame frame = run.bins();
    std::string line = fmt::format("{:3d} %: {:.1f} s, {} disks left, {} right, {} on the base", 10 * tenths,
                                   run.time(), total(frame, &SpeciesBins::left),
                                   total(frame, &SpeciesBins::right), total(frame, &SpeciesBins::on_base));
    if (frame.quality)
      line += fmt::format(", Q = {:.3f}", *frame.quality);
    ROS_INFO_STREAM(line);
  }
  // After a reset the run is at its beginning again.
  tenths_ = tenths;
}

}  // namespace ratchet_sieve
