#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

/// Groups the warnings of cases by warningId().
class WarningTally
{
public:
  /// @param warnings of one case, or of each of `cases` cases
  void add(const std::vector<std::string>& warnings, std::uint64_t cases = 1);

  std::uint64_t warned() const { return warned_; }  ///< cases with a warning

  /// One line for each of the most frequent warnings, for example `in 3 of 12 cases: ...`; if their texts
  /// differ, that of the first. @param cases total number @param noun for the items counted, for example
  /// `case`
  std::vector<std::string> lines(std::uint64_t cases, const std::string& noun) const;

private:
  struct Group
  {
    std::string first;  ///< text of the first
    bool alike = true;  ///< all texts are equal to `first`
    std::uint64_t cases = 0;
  };
  std::map<std::string, Group> groups_;  ///< by id
  std::uint64_t warned_ = 0;
};

/// The progress of a sweep in the results file.
struct SweepCounts
{
  std::uint64_t cases = 0;  ///< different ones
  std::uint64_t done = 0;
  std::uint64_t failed = 0;
  std::uint64_t other_physics = 0;  ///< results of these cases from other physics versions

  std::uint64_t open() const { return cases - done - failed; }
};

/// The progress of a process that runs a sweep.
struct SweepProgress : SweepCounts
{
  std::uint64_t warned = 0;  ///< successful, with a warning
  std::uint64_t running = 0;
  std::uint64_t finished_here = 0;  ///< successful or failed since this process began
  double wall = 0.0;                ///< wall time since then [s]
};

/// The cases of a sweep, each of them legal.
struct LegalCases
{
  std::vector<std::string> run_hashes;  ///< runHash(), by position
  WarningTally warnings;                ///< of their scenes
};

/// Builds all cases, one after the other. Returns nothing if `stop_wanted`, which may be empty.
/// @throws SceneError for the first illegal case
std::optional<LegalCases> legalCases(const Sweep& sweep, const std::function<bool()>& stop_wanted = {});

/// The cases of one sweep, or of its part, as listed in a results file: position and runHash(), each case
/// once.
class SweepPlan
{
public:
  /// The plan in the file, if it is complete.
  static std::optional<SweepPlan> find(Database& database, const Sweep& sweep);

  /// Writes the list of all cases to the file. @throws DatabaseError
  static SweepPlan make(Database& database, const Sweep& sweep, const LegalCases& cases);

  /// The plan in the file, or else one in temporary tables, for a sweep file that was changed since its run.
  /// Does not change the file. @throws SceneError if a case is illegal
  static SweepPlan findOrWorkOut(Database& database, const Sweep& sweep);

  std::int64_t id() const { return id_; }

  /// Binds ?1 and ?2 of a statement, the plan and the version of the physics.
  Statement& bind(Statement& statement) const;
  bool isInFile() const { return in_file_; }

  SweepCounts counts(Database& database) const;

  /// The warnings of the completed cases.
  WarningTally warnings(const ResultStore& store) const;

  /// Adds missing values of swept keys to cases that were run by another sweep, which did not sweep these
  /// keys.
  void fillValues(ResultStore& store, const Sweep& sweep) const;

  /// Removes the rows of failed cases, so that they are run again. @return their number
  std::int64_t removeFailed(Database& database) const;

private:
  explicit SweepPlan(std::int64_t id) : id_(id) {}
  std::int64_t id_;
  bool in_file_ = true;
};

}  // namespace ratchet_sieve
