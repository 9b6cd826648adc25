#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// Reports the number of disks that have gone over the walls: the first, and each doubling.
class WallLog
{
public:
  /// @return a line for the log, or nothing
  std::optional<std::string> line(const Simulation& simulation);

private:
  std::uint64_t said_ = 0;  ///< of the present run
};

}  // namespace ratchet_sieve
