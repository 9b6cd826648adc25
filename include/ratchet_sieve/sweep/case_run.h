#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_result.h"

namespace ratchet_sieve
{

/// Takes the frames of one case from its beginning.
struct CaseRecord
{
  std::unique_ptr<FrameSink> sink;
  FrameRates rates;
  std::function<void(const std::vector<std::string>& warnings)> keep;  ///< called once the case has ended
};

/// Opens the record of a case; called by the thread that runs it.
using OpenRecord = std::function<CaseRecord(const SweepCase&)>;

/// How a case is run. Each function may be empty.
struct CaseRunOptions
{
  std::string checkpoint;  ///< checkpoint file: resumed if it exists, written periodically; empty: none
  double checkpoint_period = 60.0;               ///< of wall time [s]
  std::function<bool()> stop_wanted;             ///< polled several times a second
  std::function<void(const std::string&)> warn;  ///< called for problems that do not end the case
  OpenRecord record;                             ///< @pre there is no checkpoint
};

/// The result of a case that has not been run.
CaseResult resultFor(const SweepCase& sweep_case);

/// Runs a case to its end in this thread. Errors become part of the result.
/// @return nothing if it was stopped; its checkpoint then has its state
std::optional<CaseResult> runCase(const SweepCase& sweep_case, const CaseRunOptions& options);

/// The name of this machine.
std::string hostName();

}  // namespace ratchet_sieve
