#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/database.h"
#include "ratchet_sieve/sweep/sweep_plan.h"

namespace ratchet_sieve
{

/// A file that this process locks during its lifetime. The kernel releases the lock even if the process is
/// killed.
class OwnerLock
{
public:
  static constexpr const char* EXTENSION = ".lock";

  /// @param directory created if missing @throws DatabaseError
  explicit OwnerLock(const std::string& directory);
  ~OwnerLock();
  OwnerLock(const OwnerLock&) = delete;
  OwnerLock& operator=(const OwnerLock&) = delete;

  const std::string& name() const { return name_; }

  /// Whether no process holds the lock of that name, or the name is not a lock's.
  static bool isGone(const std::string& directory, const std::string& name);

  /// Removes the lock files that no process holds.
  static void removeGone(const std::string& directory);

private:
  std::string directory_;
  std::string name_;
  int descriptor_ = -1;
};

/// The checkpoint of a case, which holds for one physics version, as a result does; the names of all end with
/// checkpointEnding(). @param directory of the locks
std::string checkpointPath(const std::string& directory, const std::string& run_hash);
const std::string& checkpointEnding();

/// Number of cases of a sweep that live processes are running. @param directory of the locks
std::uint64_t casesUnderWay(const Database& database, const SweepPlan& plan, const std::string& directory);

/// The cases that this process runs. Other processes with the same results file skip them while this process
/// lives. A case whose process died is suspect until it writes a checkpoint or ends. Suspects come last, and
/// one at a time, so that the one at fault is known by the next death.
class CaseClaims
{
public:
  /// @pre `plan` outlives this
  CaseClaims(Database& database, const SweepPlan& plan, const std::string& directory);

  /// Claims up to `most` cases that have no result and are not claimed, or one suspect; returns their
  /// positions.
  /// @pre a transaction is open
  std::vector<std::uint64_t> take(std::size_t most);

  /// @pre a transaction is open
  void release(const std::string& run_hash);
  void releaseAll();

  /// Makes the cases of dead processes suspect and releases them. @return the positions of those that were so
  /// before: their process died twice at the same place
  std::vector<std::uint64_t> countDeaths();

  /// Releases the claims of dead processes. @return number of cases that other processes are running
  std::uint64_t freeAbandoned();

  /// Reports once for each other process with claimed cases of this sweep that this process waits for it.
  void sayOthers(const std::function<void(const std::string&)>& say);

  /// Checks that no case is claimed any more. @pre every claimed case was run and released by its hash
  /// @throws DatabaseError if a case's hash differs from the one in the file
  void requireNone() const;

  /// The name of this process's lock.
  const std::string& owner() const { return lock_.name(); }

private:
  std::vector<std::uint64_t> search(std::size_t most);
  std::vector<std::uint64_t> searchSuspect();
  bool runsSuspect();
  std::vector<std::uint64_t> claim(Statement& select);
  void countDeaths(const std::string& owner, std::vector<std::uint64_t>& deadly);
  std::string placeOf(const std::string& run_hash) const;

  Database& database_;
  std::string directory_;
  OwnerLock lock_;
  const SweepPlan& plan_;
  std::int64_t cursor_ = 0;  ///< all positions below are claimed or done, except those released since
  std::set<std::string> said_;
  Statement select_;
  Statement select_suspect_;
  Statement claim_;
  Statement release_;
  Statement forgive_;
};

}  // namespace ratchet_sieve
