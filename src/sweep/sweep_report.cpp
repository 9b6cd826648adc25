#include "ratchet_sieve/sweep/sweep_report.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_claims.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep_plan.h"
#include "ratchet_sieve/sweep/sweep_progress.h"
#include "ratchet_sieve/sweep/sweep_run.h"

namespace ratchet_sieve
{
namespace
{

constexpr auto LONGEST_MEASUREMENT = std::chrono::seconds(1);

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

/// First what the sweep changes, then what came of it; the summary's JSON is left to the results file.
std::string exportColumns(const ResultStore& store, const std::vector<std::string>& keys)
{
  std::string names;
  const auto add = [&names](const std::string& name)
  { names += (names.empty() ? "" : ", ") + ("c." + quotedName(name)); };
  std::vector<std::string> first = keys;
  first.insert(first.end(), {"seed", "status", "error"});
  const std::vector<std::string> last = {"run_hash", "scene_hash", "version", "physics", "wall_time", "host"};
  const auto among = [](const std::vector<std::string>& list, const std::string& name)
  { return std::find(list.begin(), list.end(), name) != list.end(); };
  for (const std::string& name : first)
    add(name);
  for (const std::string& name : store.columnNames())
    if (!among(first, name) && !among(last, name) && name != "summary")
      add(name);
  for (const std::string& name : last)
    add(name);
  return names;
}

}  // namespace

std::string statusText(const Sweep& sweep, const std::string& results)
{
  if (!std::filesystem::exists(results))
    return fmt::format("{} cases, not begun\n", sweep.size());
  ResultStore store(results, Database::Access::READ);
  Database& database = store.database();
  const std::optional<SweepPlan> plan = SweepPlan::find(database, sweep);
  if (!plan)
    return fmt::format("{} cases, not begun as the sweep stands now; {} has results of others\n",
                       sweep.size(), results);
  const SweepCounts counts = plan->counts(database);
  std::string text =
      fmt::format("{} cases: {} done, {} failed, {} under way, {} to go\n", counts.cases, counts.done,
                  counts.failed, casesUnderWay(database, *plan, workDirectory(results)), counts.open());
  if (counts.other_physics > 0)
    text += fmt::format(
        "{} results of these cases are of another physics than version {} and count for nothing\n",
        counts.other_physics, PHYSICS_VERSION);
  if (const std::optional<BestCase> best = plan->best(store))
    text += fmt::format("best Q {:.4f}: {}\n", best->quality, CaseBuilder(sweep).name(best->position));
  return counts.failed > 0 ? text + failureText(database, *plan) : text;
}

std::uint64_t exportCsv(const Sweep& sweep, const std::string& results, std::ostream& out)
{
  ResultStore store(results, Database::Access::READ);
  Database& database = store.database();
  const std::optional<SweepPlan> plan = SweepPlan::find(database, sweep);
  if (!plan)
    throw DatabaseError(results + ": has no results of this sweep as it stands now: run it first");
  for (const std::string& key : sweep.keys())
    if (!store.hasColumn(key))
      throw DatabaseError(results + ": has no results of this sweep yet");
  Statement select(database, "SELECT " + exportColumns(store, sweep.keys()) + ROWS + "ORDER BY p.position");
  bindPlan(select, *plan);
  for (int column = 0; column < select.columns(); ++column)
    out << (column == 0 ? "" : ",") << csvField(select.columnName(column));
  out << "\r\n";
  std::uint64_t rows = 0;
  for (; select.step(); ++rows)
  {
    for (int column = 0; column < select.columns(); ++column)
      out << (column == 0 ? "" : ",") << csvField(select, column);
    out << "\r\n";
  }
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
  for (std::uint64_t position = 0; position < sweep.size(); ++position)
  {
    out << position + 1 << ": " << builder.name(position);
    if (select && select->bind(1, runHash(builder.at(position).scene)).bind(2, PHYSICS_VERSION).step())
      out << "  (" << select->text(0) << ')';
    if (select)
      select->reset();
    out << '\n';
  }
}

std::string estimateText(const Sweep& sweep, std::size_t threads)
{
  CaseBuilder builder(sweep);
  const SceneDefinition& scene = builder.at(0).scene;
  const auto start = std::chrono::steady_clock::now();
  const auto late = [start] { return std::chrono::steady_clock::now() - start > LONGEST_MEASUREMENT; };
  struct TooLate
  {
  };
  try
  {
    Simulation simulation(scene, 0.0,
                          [&late](std::size_t, std::size_t)
                          {
                            if (late())
                              throw TooLate();
                          });
    RunWatchers watchers;
    watchers.stop_wanted = late;
    runToEnd(simulation, watchers);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double part = scene.duration > 0.0 ? simulation.time() / scene.duration : 1.0;
    if (part > 0.0)
      return "about " +
             durationText(wall / part * static_cast<double>(sweep.size()) / static_cast<double>(threads)) +
             " by the first case";
  }
  catch (const TooLate&)
  {
    // Said below.
  }
  return "a time that is unknown: the first case takes long to begin";
}

}  // namespace ratchet_sieve
