#include "ratchet_sieve/sweep/sweep_report.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_ledger.h"
#include "ratchet_sieve/sweep/sweep_results.h"

namespace ratchet_sieve
{
namespace
{

std::string failureText(const Database& database)
{
  Statement select(database,
                   "SELECT error, COUNT(*) FROM results WHERE status = 'failed' GROUP BY error "
                   "ORDER BY COUNT(*) DESC LIMIT 5");
  std::string text;
  while (select.step())
    text += fmt::format("failed {}: {}\n", select.integer(1), select.text(0));
  return text;
}

std::int64_t casesUnderWay(const Database& database)
{
  return database
      .value("SELECT COUNT(*) FROM under_way JOIN plan USING (run_hash) WHERE physics = ?", {PHYSICS_VERSION})
      .get<std::int64_t>();
}

std::vector<std::string> warningLines(const WarningTally& warnings, const SweepCounts& counts)
{
  std::vector<std::string> lines =
      warnings.lines(counts.done, counts.done < counts.cases ? "finished case" : "case");
  for (std::string& line : lines)
    line.insert(0, "warning ");
  return lines;
}

/// A word of a sh command, in quotes where it needs them.
std::string shellWord(const std::string& text)
{
  constexpr const char* PLAIN = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_+-=.,:/@%";
  if (!text.empty() && text.find_first_not_of(PLAIN) == std::string::npos)
    return text;
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + '\'';
}

/// Arguments of sieve_run, each after a space.
std::string argumentsText(const std::vector<Assignment>& assignments)
{
  std::string text;
  for (const Assignment& assignment : assignments)
    text += " --set " + shellWord(assignment.key + '=' + assignment.value);
  return text;
}

/// A field of CSV, in quotes where it needs them: they are those of a name in SQL.
std::string csvField(const nlohmann::ordered_json& value)
{
  if (value.is_null())
    return "";
  if (value.is_number_float())
    return fmt::format("{}", value.get<double>());
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  return text.find_first_of(",\"\r\n") == std::string::npos ? text : quotedName(text);
}

/// The column of a case's arguments, which is not in the table.
constexpr const char* ARGUMENTS = "arguments";

/// First the swept keys, then the results; without the summary's JSON.
std::vector<std::string> exportColumns(const ResultStore& store, const std::vector<std::string>& keys)
{
  std::vector<std::string> names = keys;
  names.insert(names.end(), {"seed", "status", "error"});
  const std::vector<std::string> last = {ARGUMENTS, "run_hash",  "scene_hash", "version",
                                         "physics", "wall_time", "host"};
  const auto among = [](const std::vector<std::string>& list, const std::string& name)
  { return std::find(list.begin(), list.end(), name) != list.end(); };
  for (const std::string& name : store.columnNames())
    if (!among(names, name) && !among(last, name) && name != "summary")
      names.push_back(name);
  names.insert(names.end(), last.begin(), last.end());
  return names;
}

std::string argumentsOf(const Sweep& sweep, std::uint64_t position)
{
  std::string text = argumentsText(sweep.point(position / sweep.seedCount()));
  if (sweep.seeds.count > 0)
    text += " --seed " + std::to_string(sweep.seeds.at(position % sweep.seeds.count));
  return text.empty() ? text : text.substr(1);
}

}  // namespace

std::string sweepProgressText(const SweepProgress& progress)
{
  const std::uint64_t finished = progress.done + progress.failed;
  std::string text =
      fmt::format("{} of {} done, {} running", progress.done, progress.cases, progress.running);
  if (progress.failed > 0)
    text += fmt::format(", {} failed", progress.failed);
  if (progress.warned > 0)
    text += fmt::format(", {} with warnings", progress.warned);
  if (progress.finished_here > 0 && progress.wall > 0.0)
  {
    const double rate = static_cast<double>(progress.finished_here) / progress.wall;
    text += fmt::format(
        "  {:.3g} cases/s  {} to go", rate,
        durationText(static_cast<double>(progress.cases - std::min(finished, progress.cases)) / rate));
  }
  return text;
}

nlohmann::ordered_json reportBasis(const Sweep& sweep, const std::string& results, const std::string& scene)
{
  const SweepResults file(sweep, results, Database::Access::READ);
  return {{"command", "sieve_run " + shellWord(scene) + argumentsText(sweep.fixed)},
          {"seeds", sweep.seedCount()},
          {"warnings", warningLines(file.warnings(), file.counts())}};
}

std::string statusText(const Sweep& sweep, const std::string& results)
{
  if (!std::filesystem::exists(results))
    return countText(sweep.sizeOfPart(), "case") + ", not begun\n";
  const bool is_run = LockedFile::isLocked(results);  // before SQLite opens it, see Database::lock()
  const SweepResults file(sweep, results, Database::Access::READ);
  const SweepCounts counts = file.counts();
  const WarningTally warnings = file.warnings();
  std::string text =
      fmt::format("{}: {} done, {} failed, {} under way, {} to go", countText(counts.cases, "case"),
                  counts.done, counts.failed, is_run ? casesUnderWay(file.database()) : 0, counts.open());
  text += warnings.warned() > 0 ? fmt::format(", {} with warnings\n", warnings.warned()) : "\n";
  if (!file.isListed())
    text +=
        "the sweep file has changed since it was run, or was never run: the figures are for the present "
        "file\n";
  if (counts.other_physics > 0)
    text += fmt::format("{} of these cases {} of another physics version than {} and {} not counted\n",
                        countText(counts.other_physics, "result"), counts.other_physics == 1 ? "is" : "are",
                        PHYSICS_VERSION, counts.other_physics == 1 ? "is" : "are");
  for (const std::string& line : warningLines(warnings, counts))
    text += line + '\n';
  return counts.failed > 0 ? text + failureText(file.database()) : text;
}

void exportCsv(const Sweep& sweep, const std::string& results, std::ostream& out)
{
  const SweepResults file(sweep, results, Database::Access::READ);
  const std::vector<std::string> keys = sweep.keys();
  const std::vector<std::string> names = exportColumns(file, keys);
  std::string columns = "position";
  std::string line;
  for (const std::string& name : names)
  {
    columns += ", " + (file.hasColumn(name) ? quotedName(name) : "NULL");
    line += (line.empty() ? "" : ",") + csvField(name);
  }
  Statement select(file.database(), "SELECT " + columns + " FROM results ORDER BY position");
  if (!select.step())
    throw DatabaseError(results + ": has no results of this sweep file: run it first");
  CaseBuilder builder(sweep);
  do
  {
    out << line << "\r\n";
    line.clear();
    const auto position = static_cast<std::uint64_t>(select.integer(0));
    for (std::size_t k = 0; k < names.size(); ++k)
    {
      nlohmann::ordered_json value = select.value(static_cast<int>(k) + 1);
      if (k < keys.size() && value.is_null())  // another sweep has run the case
        value = sqlValue(builder.at(position).values[k].second);
      else if (names[k] == ARGUMENTS)
        value = argumentsOf(sweep, position);
      else if (names[k] == "seed" && value.is_number_float())  // version 1.0 has rounded it
        value = builder.at(position).scene.seed;
      line += (k == 0 ? "" : ",") + csvField(value);
    }
  } while (select.step());
  out << line << "\r\n";
}

void listCases(const Sweep& sweep, const LegalCases& cases, const std::string& results, std::ostream& out)
{
  std::optional<ResultStore> store;
  if (std::filesystem::exists(results))
    store.emplace(results, Database::Access::READ);
  const CaseBuilder builder(sweep);
  for (std::uint64_t position = sweep.part.number - 1; position < sweep.size(); position += sweep.part.count)
  {
    out << position + 1 << ": " << builder.name(position);
    if (store)
      if (const auto status = store->statusOf(cases.run_hashes[position]))
        out << "  (" << *status << ')';
    out << '\n';
  }
}

}  // namespace ratchet_sieve
