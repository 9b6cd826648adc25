#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// Says how many disks have gone over the walls: at the first, and each time they are twice as many.
class WallLog
{
public:
  /// @return a line for the log; nothing where there is nothing new to say
  std::optional<std::string> line(const Simulation& simulation);

private:
  std::uint64_t said_ = 0;  ///< of the present run
};

}  // namespace ratchet_sieve
