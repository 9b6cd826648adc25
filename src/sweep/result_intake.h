#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep_plan.h"

namespace ratchet_sieve
{

/// Stores the results of jobs in the table. A result is accepted only if its case is in the plan, and gets
/// the values of the plan's case.
class ResultIntake
{
public:
  /// @param directory of the folders @param warn called for refused files, may be empty @pre the others
  /// outlive this
  ResultIntake(const Sweep& sweep, const SweepPlan& plan, ResultStore& store, const std::string& directory,
               std::function<void(const std::string&)> warn);

  /// Stores the results in a folder of this process, and removes their files. A file that is damaged, or
  /// contains a result of another case, is set aside. @return the new results @throws DatabaseError
  std::vector<CaseResult> take(const std::string& folder);

  /// Stores the results of coordinators that no longer run. @return the folders with results of other sweeps,
  /// which are kept
  std::vector<std::string> takeAbandoned();

private:
  enum class Strangers
  {
    REFUSED,  ///< results of cases that are not in the plan
    KEPT,
  };
  std::vector<CaseResult> takeFrom(const std::string& folder, Strangers strangers);
  std::vector<CaseResult> takeFile(const std::string& path, Strangers strangers);
  bool complete(CaseResult& result, const std::string& path);
  std::vector<CaseResult> record(const std::vector<CaseResult>& results);
  void setAside(const std::string& path, const std::string& reason);
  void warn(const std::string& text) const;

  const SweepPlan& plan_;
  ResultStore& store_;
  std::string directory_;
  std::function<void(const std::string&)> warn_;
  CaseBuilder builder_;
  Statement position_;
  std::set<std::string> kept_;  ///< folders without further results of this sweep
};

/// The folder of a coordinator's job files. @param owner OwnerLock::name()
std::string jobFolder(const std::string& directory, const std::string& owner);

}  // namespace ratchet_sieve
