#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_results.h"

namespace ratchet_sieve
{

/// The directory of checkpoints, beside the results file.
std::string workDirectory(const std::string& results);

/// The checkpoint of a case, which holds for one physics version, as a result does; the names of all end with
/// checkpointEnding().
std::string checkpointPath(const std::string& results, const std::string& run_hash);
const std::string& checkpointEnding();

/// What a run writes to the results file, and the sweep's progress in it. The file lists the cases under way,
/// so that those of a process that died are known. Such a case is suspect until it writes a checkpoint or
/// ends. Suspects come last, and one at a time, so that the one at fault is known by the next death.
class SweepLedger
{
public:
  /// Makes the cases under way suspect, for their process died. Those whose process died twice at the same
  /// place get a result: they failed. @pre the results were opened for writing @throws DatabaseError
  SweepLedger(const Sweep& sweep, SweepResults& results);

  /// One line on the cases that failed so, empty if there are none.
  const std::string& deaths() const { return deaths_; }

  /// In one transaction: stores a result, if there is one, and begins a case without a result, if there is
  /// one.
  /// @return its position @throws DatabaseError; nothing is changed then
  std::optional<std::uint64_t> exchange(const std::optional<CaseResult>& finished, bool begin_next = true);

  /// Whether no case was begun because a suspect is under way.
  bool waits() const { return waits_; }

  /// Forgets the cases under way, which were stopped.
  void forgetUnfinished() { results_.database().execute("DELETE FROM under_way"); }

  SweepProgress progress() const;

private:
  std::optional<std::uint64_t> begin();
  bool runsSuspect();
  void forgive(const std::string& run_hash);
  std::vector<std::uint64_t> countDeaths();
  std::string placeOf(const std::string& run_hash) const;

  SweepResults& results_;
  std::string deaths_;
  std::int64_t cursor_ = 0;  ///< all positions below have been begun or are suspect
  bool waits_ = false;
  SweepProgress progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ratchet_sieve
