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
  /// @param source of the warning: a case, or one of `cases` cases alike. Those of a source come in
  /// succession
  void add(std::uint64_t source, const std::string& warning, std::uint64_t cases = 1);

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
    std::optional<std::uint64_t> last_source = {};
  };
  std::map<std::string, Group> groups_;  ///< by id
  std::optional<std::uint64_t> last_source_;
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

/// A results file as one sweep, or its part, sees it. Its connection has two views of the file: `plan`
/// (position, run_hash) lists the sweep's cases, each once; `results` has the rows of `cases` of these and of
/// this physics version, with their position.
class SweepResults : public ResultStore
{
public:
  /// Opens a results file, or a new one to write. To read, cases that the file does not list are worked out,
  /// as of a sweep file that was changed since its run. @throws DatabaseError @throws SceneError if one is
  /// illegal
  SweepResults(const Sweep& sweep, const std::string& path, Database::Access access);

  /// Whether the file lists the sweep's cases, as it does once the sweep has been run.
  bool isListed() const { return is_listed_; }

  /// Lists the sweep's cases in the file. @pre it is open to write, and does not list them
  void list(const LegalCases& cases);

  SweepCounts counts() const;

  /// The warnings of the completed cases.
  WarningTally warnings() const;

  /// Adds missing values of swept keys to cases that were run by another sweep, which did not sweep these
  /// keys.
  void fillValues();

  /// Removes the rows of failed cases, so that they are run again.
  void removeFailed();

private:
  void workOut(const LegalCases& cases);

  const Sweep& sweep_;
  bool is_listed_;
};

}  // namespace ratchet_sieve
