#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/database.h"
#include "ratchet_sieve/sweep/sweep_plan.h"

namespace ratchet_sieve
{

/// A file that this process holds locked as long as it lives: the kernel lets go of it, whatever ends the
/// process.
class OwnerLock
{
public:
  /// @param directory that is there @throws DatabaseError
  explicit OwnerLock(const std::string& directory);
  ~OwnerLock();
  OwnerLock(const OwnerLock&) = delete;
  OwnerLock& operator=(const OwnerLock&) = delete;

  const std::string& name() const { return name_; }

  /// Whether nobody holds the lock of that name any more.
  static bool isGone(const std::string& directory, const std::string& name);

private:
  std::string directory_;
  std::string name_;
  int descriptor_ = -1;
};

/// Cases of a sweep that processes which live are at. @param directory of the locks
std::uint64_t casesUnderWay(const Database& database, const SweepPlan& plan, const std::string& directory);

/// Which cases this process runs. Others on the same results file leave them alone, as long as it lives.
class CaseClaims
{
public:
  /// @pre `plan` lives as long
  CaseClaims(Database& database, const SweepPlan& plan, const std::string& directory);

  /// Claims up to `most` cases that nobody runs and of which there is no result; their positions.
  /// @pre a transaction is open
  std::vector<std::uint64_t> take(std::size_t most);

  /// @pre a transaction is open
  void release(const std::string& run_hash);
  void releaseAll();

  /// Frees what processes have claimed that are no more. @return how many cases others are at
  std::uint64_t freeAbandoned();

private:
  std::vector<std::uint64_t> search(std::size_t most);

  Database& database_;
  std::string directory_;
  OwnerLock lock_;
  const SweepPlan& plan_;
  std::int64_t cursor_ = 0;  ///< before it all is claimed or done, but for what was freed since
  Statement select_;
  Statement claim_;
  Statement release_;
};

}  // namespace ratchet_sieve
