#include "ratchet_sieve/live/wall_log.h"

#include <algorithm>

#include "ratchet_sieve/recording/wall_warnings.h"

namespace ratchet_sieve
{

std::optional<std::string> WallLog::line(const Simulation& simulation)
{
  const std::uint64_t count = disksOverWalls(simulation);
  // After a reset the count is smaller.
  said_ = std::min(said_, count);
  if (count == 0 || count < 2 * said_)
    return std::nullopt;
  said_ = count;
  return overWallsText(simulation);
}

}  // namespace ratchet_sieve
