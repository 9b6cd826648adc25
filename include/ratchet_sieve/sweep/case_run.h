#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_result.h"

namespace ratchet_sieve
{

/// How a case is run; each function may be empty.
struct CaseRunOptions
{
  std::string checkpoint;             ///< taken up if it is there, written now and then; empty: none
  double checkpoint_period = 60.0;    ///< of wall time [s]
  std::function<bool()> stop_wanted;  ///< looked at several times a second
  std::function<void(const std::string&)> warn;  ///< of what does not keep the case from its end
};

/// Runs a case to its end, in this thread. Whatever goes wrong in it is its result.
/// @return nothing where it was stopped; its checkpoint is then as far as it came
std::optional<CaseResult> runCase(const SweepCase& sweep_case, const CaseRunOptions& options);

/// The name of this machine.
std::string hostName();

}  // namespace ratchet_sieve
