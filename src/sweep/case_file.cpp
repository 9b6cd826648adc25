#include "ratchet_sieve/sweep/case_file.h"

#include <filesystem>
#include <fstream>
#include <optional>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case_run.h"

// A line of JSON that says what the file is and of which version, and a line for each case or result.
namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

std::string firstLine(const char* kind, std::size_t lines)
{
  return Json({{"ratchet_sieve", kind},
               {"version", version()},
               {"physics", PHYSICS_VERSION},
               {"lines", lines}})
      .dump();
}

/// The lines after the first. @throws CaseFileError
std::vector<Json> readLines(const std::string& path, const char* kind)
{
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line))
    throw CaseFileError(path + ": cannot be read");
  std::vector<Json> lines;
  std::string first = line;
  try
  {
    while (std::getline(file, line))
      lines.push_back(Json::parse(line));
  }
  catch (const Json::exception& error)
  {
    throw CaseFileError(path + ": is damaged: " + error.what());
  }
  if (first != firstLine(kind, lines.size()))
    throw CaseFileError(path + ": is no whole file of " + kind + " of version " + version() +
                        ", but begins with " + first.substr(0, 100));
  return lines;
}

template <typename Entry, typename Write>
void writeLines(const std::string& path, const char* kind, const std::vector<Entry>& entries, Write&& write)
{
  AtomicFile file(path);
  file.stream() << firstLine(kind, entries.size()) << '\n';
  for (const Entry& entry : entries)
    file.stream() << write(entry).dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  file.commit();
}

Json valuesJson(const std::vector<std::optional<std::string>>& values)
{
  Json list = Json::array();
  for (const auto& value : values)
    list.push_back(value ? Json(*value) : Json(nullptr));
  return list;
}

std::vector<std::optional<std::string>> valuesOf(const Json& list)
{
  std::vector<std::optional<std::string>> values;
  for (const Json& value : list)
    values.push_back(value.is_null() ? std::nullopt : std::optional(value.get<std::string>()));
  return values;
}

Json caseJson(const SweepCase& sweep_case)
{
  return {{"run_hash", runHash(sweep_case.scene)},
          {"scene", canonicalYaml(sweep_case.scene)},
          {"warnings", sweep_case.warnings},
          {"values", valuesJson(sweep_case.values)}};
}

SweepCase caseOf(const Json& json, const std::string& path)
{
  SweepCase sweep_case;
  sweep_case.scene = sceneFromText(json.at("scene"), path).definition;
  sweep_case.warnings = json.at("warnings").get<std::vector<std::string>>();
  sweep_case.values = valuesOf(json.at("values"));
  if (runHash(sweep_case.scene) != json.at("run_hash"))
    throw CaseFileError(path + ": a scene of it is read in another way than it was written");
  return sweep_case;
}

Json resultJson(const CaseResult& result)
{
  return {{"run_hash", result.run_hash}, {"scene_hash", result.scene_hash},    {"seed", result.seed},
          {"error", result.error},       {"wall_time", result.wall_time},      {"host", result.host},
          {"summary", result.summary},   {"values", valuesJson(result.values)}};
}

CaseResult resultOf(const Json& json)
{
  CaseResult result;
  result.run_hash = json.at("run_hash");
  result.scene_hash = json.at("scene_hash");
  result.seed = json.at("seed");
  result.error = json.at("error");
  result.wall_time = json.at("wall_time");
  result.host = json.at("host");
  result.summary = json.at("summary");
  result.values = valuesOf(json.at("values"));
  return result;
}

}  // namespace

std::string resultPath(const std::string& case_path)
{
  return std::filesystem::path(case_path).replace_extension(".results").string();
}

void writeCaseFile(const std::string& path, const std::vector<SweepCase>& cases)
{
  writeLines(path, "cases", cases, caseJson);
}

bool runCaseFile(const std::string& path, const std::function<bool()>& stop_wanted)
{
  if (std::filesystem::exists(resultPath(path)))
    return true;
  std::vector<CaseResult> results;
  CaseRunOptions options;
  options.stop_wanted = stop_wanted;
  try
  {
    for (const Json& line : readLines(path, "cases"))
    {
      std::optional<CaseResult> result = runCase(caseOf(line, path), options);
      if (!result)
        return false;
      results.push_back(std::move(*result));
    }
  }
  catch (const Json::exception& error)
  {
    throw CaseFileError(path + ": is damaged: " + error.what());
  }
  writeLines(resultPath(path), "results", results, resultJson);
  return true;
}

std::vector<CaseResult> readResultFile(const std::string& path)
{
  std::vector<CaseResult> results;
  try
  {
    for (const Json& line : readLines(path, "results"))
      results.push_back(resultOf(line));
  }
  catch (const Json::exception& error)
  {
    throw CaseFileError(path + ": is damaged: " + error.what());
  }
  return results;
}

}  // namespace ratchet_sieve
