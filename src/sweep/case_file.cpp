#include "ratchet_sieve/sweep/case_file.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>

#include "json_lines.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case_run.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* CASES = "cases";
constexpr const char* RESULTS = "results";

Json caseJson(const SweepCase& sweep_case)
{
  return {{"run_hash", runHash(sweep_case.scene)},
          {"scene", canonicalYaml(sweep_case.scene)},
          {"warnings", sweep_case.warnings}};
}

SweepCase caseOf(const Json& json, const std::string& path)
{
  SweepCase sweep_case;
  sweep_case.scene = sceneFromText(json.at("scene"), path).definition;
  sweep_case.warnings = json.at("warnings").get<std::vector<std::string>>();
  if (runHash(sweep_case.scene) != json.at("run_hash"))
    throw CaseFileError(path + ": the hash of a scene does not match");
  return sweep_case;
}

Json resultJson(const CaseResult& result)
{
  return {{"run_hash", result.run_hash},
          {"error", result.error},
          {"wall_time", result.wall_time},
          {"host", result.host},
          {"summary", result.summary}};
}

CaseResult resultOf(const Json& json, const std::string& path)
{
  CaseResult result;
  result.run_hash = json.at("run_hash");
  result.error = json.at("error");
  result.wall_time = json.at("wall_time");
  result.host = json.at("host");
  result.summary = json.at("summary");
  if (!result.summary.is_object() && (!result.summary.is_null() || result.error.empty()))
    throw CaseFileError(path + ": is damaged: a successful case has no summary");
  summaryColumns(result.summary);  // throws if it is no summary
  return result;
}

/// The results of `read` for each line of a file.
template <typename Read>
auto readEach(const std::string& path, const char* kind, Read&& read)
{
  std::vector<decltype(read(Json(), path))> all;
  try
  {
    for (const Json& line : readJsonLines(path, kind))
      all.push_back(read(line, path));
  }
  catch (const Json::exception& error)
  {
    throw CaseFileError(path + ": is damaged: " + error.what());
  }
  return all;
}

}  // namespace

std::string resultPath(const std::string& case_path)
{
  return std::filesystem::path(case_path).replace_extension(".results").string();
}

void writeCaseFile(const std::string& path, const std::vector<SweepCase>& cases)
{
  std::vector<Json> lines;
  std::transform(cases.begin(), cases.end(), std::back_inserter(lines), caseJson);
  writeJsonLines(path, CASES, lines);
}

bool runCaseFile(const std::string& path, const std::function<bool()>& stop_wanted)
{
  if (std::filesystem::exists(resultPath(path)))
    return true;
  std::vector<Json> results;
  CaseRunOptions options;
  options.stop_wanted = stop_wanted;
  for (const SweepCase& sweep_case : readEach(path, CASES, caseOf))
  {
    const std::optional<CaseResult> result = runCase(sweep_case, options);
    if (!result)
      return false;
    results.push_back(resultJson(*result));
  }
  writeJsonLines(resultPath(path), RESULTS, results);
  return true;
}

std::vector<CaseResult> readResultFile(const std::string& path)
{
  return readEach(path, RESULTS, resultOf);
}

}  // namespace ratchet_sieve
