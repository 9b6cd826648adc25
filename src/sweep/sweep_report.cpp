#include "ratchet_sieve/sweep/sweep_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep_ledger.h"
#include "ratchet_sieve/sweep/sweep_plan.h"

namespace ratchet_sieve
{
namespace
{

constexpr auto REDRAW_INTERVAL = std::chrono::milliseconds(100);
constexpr const char* CLEAR_LINE = "\r\x1b[K";

const char* const ROWS =
    " FROM plan p JOIN cases c ON c.run_hash = p.run_hash WHERE p.sweep = ?1 AND c.physics = ?2 ";

std::string failureText(Database& database, const SweepPlan& plan)
{
  Statement select(database, std::string("SELECT c.error, COUNT(*)") + ROWS +
                                 "AND c.status = 'failed' GROUP BY c.error ORDER BY COUNT(*) DESC LIMIT 5");
  plan.bind(select);
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
  plan.bind(select).step();
  return static_cast<std::uint64_t>(select.integer(0));
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
std::string csvField(const std::string& text)
{
  return text.find_first_of(",\"\r\n") == std::string::npos ? text : quotedName(text);
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

std::string durationText(double seconds)
{
  constexpr double DAY = 86400.0;
  if (seconds >= 1000 * DAY)
    return fmt::format("{:.3g} years", seconds / (365.25 * DAY));
  if (seconds >= 2 * DAY)
    return fmt::format("{:.0f} days", seconds / DAY);
  const long whole = std::lround(seconds);
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

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

SweepProgressLine::SweepProgressLine()
    : visible_(isatty(STDERR_FILENO) == 1), next_(std::chrono::steady_clock::now())
{
}

void SweepProgressLine::show(const SweepProgress& progress)
{
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || now < next_)
    return;
  next_ = now + REDRAW_INTERVAL;
  fmt::print(stderr, "\r{}\x1b[K", sweepProgressText(progress));
  std::fflush(stderr);
}

SweepProgressLine::~SweepProgressLine()
{
  if (visible_)
    std::fputs(CLEAR_LINE, stderr);
}

nlohmann::ordered_json reportBasis(const Sweep& sweep, const std::string& results, const std::string& scene)
{
  ResultStore store(results, Database::Access::READ);
  const SweepPlan plan = SweepPlan::findOrWorkOut(store.database(), sweep);
  return {{"command", "sieve_run " + shellWord(scene) + argumentsText(sweep.fixed)},
          {"seeds", sweep.seedCount()},
          {"warnings", warningLines(plan.warnings(store), plan.counts(store.database()))}};
}

std::string statusText(const Sweep& sweep, const std::string& results)
{
  if (!std::filesystem::exists(results))
    return countText(sweep.sizeOfPart(), "case") + ", not begun\n";
  ResultStore store(results, Database::Access::READ);
  Database& database = store.database();
  const SweepPlan plan = SweepPlan::findOrWorkOut(database, sweep);
  const SweepCounts counts = plan.counts(database);
  const WarningTally warnings = plan.warnings(store);
  std::string text =
      fmt::format("{}: {} done, {} failed, {} under way, {} to go", countText(counts.cases, "case"),
                  counts.done, counts.failed, casesUnderWay(database, plan), counts.open());
  text += warnings.warned() > 0 ? fmt::format(", {} with warnings\n", warnings.warned()) : "\n";
  if (!plan.isInFile())
    text +=
        "the sweep file has changed since it was run, or was never run: the figures are for the present "
        "file\n";
  if (counts.other_physics > 0)
    text += fmt::format("{} of these cases {} of another physics version than {} and {} not counted\n",
                        countText(counts.other_physics, "result"), counts.other_physics == 1 ? "is" : "are",
                        PHYSICS_VERSION, counts.other_physics == 1 ? "is" : "are");
  for (const std::string& line : warningLines(warnings, counts))
    text += line + '\n';
  return counts.failed > 0 ? text + failureText(database, plan) : text;
}

void exportCsv(const Sweep& sweep, const std::string& results, std::ostream& out)
{
  ResultStore store(results, Database::Access::READ);
  Database& database = store.database();
  const SweepPlan plan = SweepPlan::findOrWorkOut(database, sweep);
  Statement select(database, "SELECT " + exportColumns(store, sweep.keys()) + ROWS + "ORDER BY p.position");
  plan.bind(select);
  if (!select.step())
    throw DatabaseError(results + ": has no results of this sweep file: run it first");
  for (int column = 1; column < select.columns(); ++column)
    out << (column == 1 ? "" : ",") << csvField(select.columnName(column));
  out << "\r\n";
  const int keys = static_cast<int>(sweep.keys().size());
  MissingFields missing(sweep, database);
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
  } while (select.step());
}

void listCases(const Sweep& sweep, const LegalCases& cases, const std::string& results, std::ostream& out)
{
  std::optional<ResultStore> store;
  std::optional<Statement> select;
  if (std::filesystem::exists(results))
  {
    store.emplace(results, Database::Access::READ);
    select.emplace(store->database(), "SELECT status FROM cases WHERE run_hash = ? AND physics = ?");
  }
  const CaseBuilder builder(sweep);
  for (std::uint64_t position = sweep.part.number - 1; position < sweep.size(); position += sweep.part.count)
  {
    out << position + 1 << ": " << builder.name(position);
    if (select && select->bind(1, cases.run_hashes[position]).bind(2, PHYSICS_VERSION).step())
      out << "  (" << select->text(0) << ')';
    if (select)
      select->reset();
    out << '\n';
  }
}

}  // namespace ratchet_sieve
