#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// Reports once when a run reaches the accuracy that its scene requests. Unlike a batch run, a node's run
/// does not end then: the user decides when it ends.
class CertaintyLog
{
public:
  /// @return a line for the log, or nothing
  std::optional<std::string> line(const Simulation& simulation);

private:
  bool said_ = false;           ///< of the present run
  double start_ = 0.0;          ///< of the present run [s]
  double last_time_ = 0.0;      ///< [s]
  std::optional<double> next_;  ///< time of the next check [s]
};

}  // namespace ratchet_sieve
