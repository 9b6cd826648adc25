#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// Says once, of a run whose scene asks for a certainty, that it has come to it. A run under command goes on
/// all the same: whoever commands and watches it decides when it ends.
class CertaintyLog
{
public:
  /// @return a line for the log; nothing where there is nothing new to say
  std::optional<std::string> line(const Simulation& simulation);

private:
  bool said_ = false;           ///< of the present run
  double start_ = 0.0;          ///< of the present run [s]
  double last_time_ = 0.0;      ///< [s]
  std::optional<double> next_;  ///< time of the next look [s]
};

}  // namespace ratchet_sieve
