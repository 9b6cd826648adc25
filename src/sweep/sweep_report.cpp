#include "ratchet_sieve/sweep/sweep_report.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "quoted_word.h"
#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep_plan.h"
#include "ratchet_sieve/sweep/work_directory.h"

namespace ratchet_sieve
{
namespace
{

const char* const ROWS =
    " FROM plan p JOIN cases c ON c.run_hash = p.run_hash WHERE p.sweep = ?1 AND c.physics = ?2 ";

Statement& bindPlan(Statement& statement, const SweepPlan& plan)
{
  return statement.bind(1, plan.id()).bind(2, PHYSICS_VERSION);
}

std::string failureText(Database& database, const SweepPlan& plan)
{
  Statement select(database, std::string("SELECT c.error, COUNT(*)") + ROWS +
                                 "AND c.status = 'failed' GROUP BY c.error ORDER BY COUNT(*) DESC LIMIT 5");
  bindPlan(select, plan);
  std::string text;
  while (select.step())
    text += fmt::format("failed {}: {}\n", select.integer(1), select.text(0));
  return text;
}

/// The number that a live process runs.
std::uint64_t casesUnderWay(const Database& database, const SweepPlan& plan)
{
  if (!ResultsLock::isHeld(database.path()))
    return 0;
  Statement select(database,
                   "SELECT COUNT(*) FROM under_way u JOIN plan p ON p.sweep = ?1 AND "
                   "p.run_hash = u.run_hash WHERE physics = ?2");
  bindPlan(select, plan).step();
  return static_cast<std::uint64_t>(select.integer(0));
}

SweepFindings findingsOf(const Sweep& sweep, ResultStore& store, const SweepPlan& plan,
                         const BestCriteria& criteria)
{
  SweepFindings findings = {criteria, bestSetting(store, plan, sweep, criteria), 0, {}};
  const std::string best = bestText(store, plan, sweep, criteria, findings.best);
  if (!best.empty())
    findings.lines.push_back(best);
  const SweepCounts counts = plan.counts(store.database());
  const std::string noun = counts.done < counts.cases ? "finished case" : "case";
  const WarningTally warnings = plan.warnings(store);
  findings.warned = warnings.warned();
  for (const std::string& line : warnings.lines(counts.done, noun))
    findings.lines.push_back("warning " + line);
  return findings;
}

/// Arguments of sieve_run, each after a space.
std::string argumentsText(const std::vector<Assignment>& assignments)
{
  std::string text;
  for (const Assignment& assignment : assignments)
    text += " --set " + plainWord(assignment.key + '=' + assignment.value);
  return text;
}

/// A field of CSV, in quotes where it needs them.
std::string csvField(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csvField(const Statement& row, int column)
{
  if (row.isNull(column))
    return "";
  if (row.isReal(column))
    return fmt::format("{}", row.real(column));
  return csvField(row.text(column));
}

/// The column of a case's arguments, which is not in the table.
constexpr const char* ARGUMENTS = "arguments";

/// First the swept keys, then the results; without the summary's JSON.
std::string exportColumns(const ResultStore& store, const std::vector<std::string>& keys)
{
  std::string names = "p.position";
  std::vector<std::string> first = keys;
  first.insert(first.end(), {"seed", "status", "error"});
  const std::vector<std::string> last = {"run_hash", "scene_hash", "version", "physics", "wall_time", "host"};
  const auto among = [](const std::vector<std::string>& list, const std::string& name)
  { return std::find(list.begin(), list.end(), name) != list.end(); };
  for (const std::string& name : first)
    names += ", " + (store.hasColumn(name) ? "c." + quotedName(name) : "NULL AS " + quotedName(name));
  for (const std::string& name : store.columnNames())
    if (!among(first, name) && !among(last, name) && name != "summary")
      names += ", c." + quotedName(name);
  names += std::string(", NULL AS ") + ARGUMENTS;
  for (const std::string& name : last)
    names += ", c." + quotedName(name);
  return names;
}

/// What a row of the table lacks.
class MissingFields
{
public:
  MissingFields(const Sweep& sweep, const Database& database)
      : sweep_(sweep), builder_(sweep), sqlite_value_(database, "SELECT ?1")
  {
  }

  std::string arguments(std::uint64_t position) const
  {
    std::string text = argumentsText(sweep_.point(position / sweep_.seedCount()));
    if (sweep_.seeds.count > 0)
      text += " --seed " + std::to_string(sweep_.seeds.at(position % sweep_.seeds.count));
    return csvField(text.empty() ? text : text.substr(1));
  }

  /// The value of a swept key, if another sweep has run the case; in the same form as from the table.
  std::string sweptValue(std::uint64_t position, int key)
  {
    bindValue(sqlite_value_, 1, builder_.at(position).values[static_cast<std::size_t>(key)].second);
    sqlite_value_.step();
    std::string text = csvField(sqlite_value_, 0);
    sqlite_value_.reset();
    return text;
  }

private:
  const Sweep& sweep_;
  CaseBuilder builder_;
  Statement sqlite_value_;
};

}  // namespace

SweepFindings findingsOf(const Sweep& sweep, const std::string& results, const BestCriteria& criteria)
{
  ResultStore store(results, Database::Access::READ);
  const SweepPlan plan = SweepPlan::findOrWorkOut(store.database(), sweep);
  return findingsOf(sweep, store, plan, criteria);
}

nlohmann::ordered_json findingsJson(const Sweep& sweep, const SweepFindings& findings)
{
  nlohmann::ordered_json json = {{"lines", findings.lines},
                                 {"least_processed", findings.criteria.least_processed},
                                 {"least_counted", findings.criteria.least_counted},
                                 {"best", nullptr}};
  if (!findings.best)
    return json;
  const SettingMean& best = *findings.best;
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  CaseBuilder builder(sweep);
  for (const auto& [key, value] : builder.at(best.point * sweep.seedCount()).values)
    values[key] = value.value_or("");
  json["best"] = {{"values", values},
                  {"quality", best.quality()},
                  {"separation", best.separation},
                  {"quality_stderr", numberOrNull(best.error)},
                  {"seeds", best.seeds},
                  {"processed", best.processed},
                  {"counted", best.counted},
                  {"at_edge", keysAtEdge(sweep, best.point, findings.criteria.where)}};
  return json;
}

std::string commandText(const Sweep& sweep, const std::string& scene)
{
  return "sieve_run " + plainWord(scene) + argumentsText(sweep.fixed);
}

std::string statusText(const Sweep& sweep, const std::string& results, const BestCriteria& criteria)
{
  if (!std::filesystem::exists(results))
    return countText(sweep.sizeOfPart(), "case") + ", not begun\n";
  ResultStore store(results, Database::Access::READ);
  Database& database = store.database();
  const SweepPlan plan = SweepPlan::findOrWorkOut(database, sweep);
  const SweepCounts counts = plan.counts(database);
  const SweepFindings findings = findingsOf(sweep, store, plan, criteria);
  std::string text =
      fmt::format("{}: {} done, {} failed, {} under way, {} to go", countText(counts.cases, "case"),
                  counts.done, counts.failed, casesUnderWay(database, plan), counts.open());
  text += findings.warned > 0 ? fmt::format(", {} with warnings\n", findings.warned) : "\n";
  if (!plan.isInFile())
    text +=
        "the sweep file has changed since it was run, or was never run: the figures are for the present "
        "file\n";
  if (counts.other_physics > 0)
    text += fmt::format("{} of these cases {} of another physics version than {} and {} not counted\n",
                        countText(counts.other_physics, "result"), counts.other_physics == 1 ? "is" : "are",
                        PHYSICS_VERSION, counts.other_physics == 1 ? "is" : "are");
  for (const std::string& line : findings.lines)
    text += line + '\n';
  return counts.failed > 0 ? text + failureText(database, plan) : text;
}

std::uint64_t exportCsv(const Sweep& sweep, const std::string& results, std::ostream& out)
{
  ResultStore store(results, Database::Access::READ);
  Database& database = store.database();
  const SweepPlan plan = SweepPlan::findOrWorkOut(database, sweep);
  Statement select(database, "SELECT " + exportColumns(store, sweep.keys()) + ROWS + "ORDER BY p.position");
  bindPlan(select, plan);
  if (!select.step())
    throw DatabaseError(results + ": has no results of this sweep file: run it first");
  for (int column = 1; column < select.columns(); ++column)
    out << (column == 1 ? "" : ",") << csvField(select.columnName(column));
  out << "\r\n";
  const int keys = static_cast<int>(sweep.keys().size());
  MissingFields missing(sweep, database);
  std::uint64_t rows = 0;
  do
  {
    const auto position = static_cast<std::uint64_t>(select.integer(0));
    for (int column = 1; column < select.columns(); ++column)
    {
      out << (column == 1 ? "" : ",");
      if (column <= keys && select.isNull(column))
        out << missing.sweptValue(position, column - 1);
      else if (select.columnName(column) == ARGUMENTS)
        out << missing.arguments(position);
      else
        out << csvField(select, column);
    }
    out << "\r\n";
    ++rows;
  } while (select.step());
  return rows;
}

void listCases(const Sweep& sweep, const std::string& results, std::ostream& out)
{
  std::optional<ResultStore> store;
  std::optional<Statement> select;
  if (std::filesystem::exists(results))
  {
    store.emplace(results, Database::Access::READ);
    select.emplace(store->database(), "SELECT status FROM cases WHERE run_hash = ? AND physics = ?");
  }
  CaseBuilder builder(sweep);
  for (std::uint64_t position = sweep.part.number - 1; position < sweep.size(); position += sweep.part.count)
  {
    out << position + 1 << ": " << builder.name(position);
    if (select && select->bind(1, runHash(builder.at(position).scene)).bind(2, PHYSICS_VERSION).step())
      out << "  (" << select->text(0) << ')';
    if (select)
      select->reset();
    out << '\n';
  }
}

}  // namespace ratchet_sieve
