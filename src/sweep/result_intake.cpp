#include "result_intake.h"

#include <filesystem>
#include <iterator>
#include <utility>

#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/sweep/case_claims.h"
#include "ratchet_sieve/sweep/case_file.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* FOLDER = ".cases";

/// The paths in a directory with this extension. Others may remove some of them at the same time.
std::vector<fs::path> pathsIn(const fs::path& directory, const char* extension)
{
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == extension)
      paths.push_back(entry->path());
  return paths;
}

bool isOf(const nlohmann::ordered_json& summary, const CaseResult& result)
{
  return summary.is_null() || (summary.contains("scene_hash") && summary["scene_hash"] == result.scene_hash &&
                               summary.contains("seed") && summary["seed"] == result.seed);
}

}  // namespace

std::string jobFolder(const std::string& directory, const std::string& owner)
{
  return directory + '/' + fs::path(owner).stem().string() + FOLDER;
}

ResultIntake::ResultIntake(const Sweep& sweep, const SweepPlan& plan, ResultStore& store,
                           const std::string& directory, std::function<void(const std::string&)> warn)
    : plan_(plan),
      store_(store),
      directory_(directory),
      warn_(std::move(warn)),
      builder_(sweep),
      position_(store.database(), "SELECT position FROM plan WHERE sweep = ? AND run_hash = ?")
{
}

std::vector<CaseResult> ResultIntake::take(const std::string& folder)
{
  return takeFrom(folder, Strangers::REFUSED);
}

std::vector<std::string> ResultIntake::takeAbandoned()
{
  for (const fs::path& folder : pathsIn(directory_, FOLDER))
  {
    if (!fs::is_directory(fs::symlink_status(folder)) ||
        !OwnerLock::isGone(directory_, folder.stem().string() + OwnerLock::EXTENSION) ||
        kept_.count(folder.string()) > 0)
      continue;
    // A late job then finds no case to run.
    std::error_code ignored;
    for (const fs::path& cases : pathsIn(folder, ".case"))
      fs::remove(cases, ignored);
    takeFrom(folder.string(), Strangers::KEPT);
    if (pathsIn(folder, ".results").empty())
      fs::remove_all(folder, ignored);
    else
      kept_.insert(folder.string());
  }
  return {kept_.begin(), kept_.end()};
}

std::vector<CaseResult> ResultIntake::takeFrom(const std::string& folder, Strangers strangers)
{
  std::vector<CaseResult> all;
  for (const fs::path& path : pathsIn(folder, ".results"))
  {
    std::vector<CaseResult> taken = takeFile(path.string(), strangers);
    std::move(taken.begin(), taken.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<CaseResult> ResultIntake::takeFile(const std::string& path, Strangers strangers)
{
  std::vector<CaseResult> known;
  bool is_all_known = true;
  try
  {
    for (CaseResult& result : readResultFile(path))
      if (complete(result, path))
        known.push_back(std::move(result));
      else if (strangers == Strangers::KEPT)
        is_all_known = false;
      else
        throw CaseFileError(path + ": has a result of an unknown case");
  }
  catch (const CaseFileError& error)
  {
    setAside(path, error.what());
    return {};
  }
  std::vector<CaseResult> recorded = record(known);
  // The case file first: a late job then finds no case to run.
  fs::remove(fs::path(path).replace_extension(".case"));
  if (is_all_known)
    fs::remove(path);
  return recorded;
}

/// Adds the members of a result that are not in its file. @return whether its case is in the plan
bool ResultIntake::complete(CaseResult& result, const std::string& path)
{
  const bool is_known = position_.bind(1, plan_.id()).bind(2, result.run_hash).step();
  const auto position = is_known ? static_cast<std::uint64_t>(position_.integer(0)) : 0;
  position_.reset();
  if (!is_known)
    return false;
  const SweepCase& planned = builder_.at(position);
  result.scene_hash = sceneHash(planned.scene);
  result.seed = planned.scene.seed;
  result.values = planned.values;
  if (runHash(planned.scene) != result.run_hash || !isOf(result.summary, result))
    throw CaseFileError(path + ": has a result that does not belong to its case");
  return true;
}

std::vector<CaseResult> ResultIntake::record(const std::vector<CaseResult>& results)
{
  std::vector<CaseResult> recorded;
  try
  {
    Transaction transaction(store_.database());
    for (const CaseResult& result : results)
      if (store_.record(result))
        recorded.push_back(result);
    transaction.commit();
  }
  catch (const DatabaseError&)
  {
    store_.forgetColumns();
    throw;
  }
  return recorded;
}

void ResultIntake::setAside(const std::string& path, const std::string& reason)
{
  const fs::path file = path;
  const fs::path aside =
      fs::path(directory_) / (file.parent_path().stem().string() + '-' + file.filename().string() + ".bad");
  std::error_code error;
  fs::rename(file, aside, error);
  if (error == std::errc::no_such_file_or_directory)
    return;  // another process has taken it
  if (error)
    throw OutputError(aside.string() + ": cannot be made: " + error.message());
  fs::remove(fs::path(path).replace_extension(".case"));
  warn(reason + "; it is renamed to " + aside.string() + ", and its cases run again");
}

void ResultIntake::warn(const std::string& text) const
{
  if (warn_)
    warn_(text);
}

}  // namespace ratchet_sieve
