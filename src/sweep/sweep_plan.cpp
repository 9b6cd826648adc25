#include "ratchet_sieve/sweep/sweep_plan.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/case.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::size_t MOST_LINES = 5;

/// Rows per transaction while a plan is written: enough to be fast, few enough that other processes are not
/// blocked for long.
constexpr std::uint64_t ROWS_AT_ONCE = 2000;

/// Disks placed by hand may overlap, which only their placement detects; a pour never fails.
void requirePlaceable(const CaseBuilder& builder, const Sweep& sweep, const SweepCase& next)
{
  if (next.scene.initial.empty())
    return;
  try
  {
    const Simulation simulation(next.scene);
  }
  catch (const std::invalid_argument& error)
  {
    throw SceneError(sweep.source + ": case " + std::to_string(next.position + 1) + " (" +
                     builder.name(next.position) + "): " + error.what());
  }
}

std::int64_t beginPlan(Database& database, const Sweep& sweep)
{
  Transaction transaction(database);
  Statement insert(database, "INSERT OR IGNORE INTO sweeps (fingerprint, source, planned) VALUES (?, ?, 0)");
  insert.bind(1, sweep.fingerprint()).bind(2, sweep.source).run();
  Statement select(database, "SELECT id FROM sweeps WHERE fingerprint = ?");
  select.bind(1, sweep.fingerprint()).step();
  const std::int64_t id = select.integer(0);
  select.reset();
  transaction.commit();
  return id;
}

/// Creates temporary tables for a plan, visible to this connection only. SQL prefers them to those of the
/// file.
void shadowPlanTables(Database& database)
{
  std::vector<std::string> definitions;
  {
    Statement select(
        database,
        "SELECT name, sql FROM main.sqlite_master WHERE name IN ('sweeps', 'plan', 'plan_by_run') "
        "ORDER BY type = 'index'");
    while (select.step())
    {
      const std::string sql = select.text(1);
      const std::size_t place = std::min(lowerCase(sql).find(select.text(0)), sql.size());
      definitions.push_back(std::string(sql).insert(place, "temp."));
    }
  }
  for (const std::string& definition : definitions)
    database.execute(definition);
}

constexpr const char* ROWS_OF_PLAN =
    " FROM plan p JOIN cases c ON c.run_hash = p.run_hash WHERE p.sweep = ?1 ";

}  // namespace

void WarningTally::add(const std::vector<std::string>& warnings, std::uint64_t cases)
{
  std::set<std::string> counted;
  for (const std::string& text : warnings)
  {
    const std::string id = warningId(text);
    Group& group = groups_.try_emplace(id, Group{text}).first->second;
    group.alike = group.alike && text == group.first;
    if (counted.insert(id).second)
      group.cases += cases;
  }
  warned_ += warnings.empty() ? 0 : cases;
}

std::vector<std::string> WarningTally::lines(std::uint64_t cases, const std::string& noun) const
{
  std::vector<const Group*> order;
  for (const auto& [id, group] : groups_)
    order.push_back(&group);
  std::stable_sort(order.begin(), order.end(),
                   [](const Group* a, const Group* b) { return a->cases > b->cases; });
  std::vector<std::string> lines;
  for (const Group* group : order)
  {
    if (lines.size() == MOST_LINES)
    {
      lines.push_back("and " + countText(order.size() - MOST_LINES, "other warning"));
      break;
    }
    const std::string where = group->cases == cases
                                  ? "every " + noun
                                  : std::to_string(group->cases) + " of " + countText(cases, noun);
    lines.push_back("in " + where + (group->alike ? ": " : ", such as: ") + group->first);
  }
  return lines;
}

std::optional<LegalCases> legalCases(const Sweep& sweep, const std::function<bool()>& stop_wanted)
{
  CaseBuilder builder(sweep);
  LegalCases cases;
  for (std::uint64_t position = 0; position < sweep.size(); ++position)
  {
    const SweepCase& next = builder.at(position);
    if (position % sweep.seedCount() == 0)
    {
      requirePlaceable(builder, sweep, next);
      cases.warnings.add(next.warnings, sweep.seedCount());
    }
    cases.run_hashes.push_back(runHash(next.scene));
    if ((position + 1) % ROWS_AT_ONCE == 0 && stop_wanted && stop_wanted())
      return std::nullopt;
  }
  return cases;
}

std::optional<SweepPlan> SweepPlan::find(Database& database, const Sweep& sweep)
{
  Statement select(database, "SELECT id FROM sweeps WHERE fingerprint = ? AND planned = 1");
  select.bind(1, sweep.fingerprint());
  if (!select.step())
    return std::nullopt;
  return SweepPlan(select.integer(0));
}

SweepPlan SweepPlan::make(Database& database, const Sweep& sweep, const LegalCases& cases)
{
  const std::int64_t id = beginPlan(database, sweep);
  Statement insert(database, "INSERT OR IGNORE INTO plan (sweep, position, run_hash) VALUES (?, ?, ?)");
  const std::uint64_t count = cases.run_hashes.size();
  for (std::uint64_t first = 0; first < count; first += ROWS_AT_ONCE)
  {
    Transaction transaction(database);
    for (std::uint64_t k = first; k < std::min(first + ROWS_AT_ONCE, count); ++k)
      if (k % sweep.part.count == sweep.part.number - 1)
        insert.bind(1, id).bind(2, static_cast<std::int64_t>(k)).bind(3, cases.run_hashes[k]).run();
    transaction.commit();
  }
  Statement(database, "UPDATE sweeps SET planned = 1 WHERE id = ?").bind(1, id).run();
  return SweepPlan(id);
}

SweepPlan SweepPlan::findOrWorkOut(Database& database, const Sweep& sweep)
{
  if (const std::optional<SweepPlan> plan = find(database, sweep))
    return *plan;
  database.execute("PRAGMA query_only = 0");
  shadowPlanTables(database);
  SweepPlan plan = make(database, sweep, *legalCases(sweep));
  database.execute("PRAGMA query_only = 1");
  plan.in_file_ = false;
  return plan;
}

Statement& SweepPlan::bind(Statement& statement) const
{
  return statement.bind(1, id_).bind(2, PHYSICS_VERSION);
}

SweepCounts SweepPlan::counts(Database& database) const
{
  Statement rows(
      database,
      "SELECT COUNT(*), COUNT(c.status), SUM(c.status IS 'failed') "
      "FROM plan p LEFT JOIN cases c ON c.run_hash = p.run_hash AND c.physics = ?2 WHERE p.sweep = ?1");
  bind(rows).step();
  SweepCounts counts;
  counts.cases = static_cast<std::uint64_t>(rows.integer(0));
  counts.failed = static_cast<std::uint64_t>(rows.integer(2));
  counts.done = static_cast<std::uint64_t>(rows.integer(1)) - counts.failed;
  Statement others(database, std::string("SELECT COUNT(*)") + ROWS_OF_PLAN + "AND c.physics <> ?2");
  bind(others).step();
  counts.other_physics = static_cast<std::uint64_t>(others.integer(0));
  return counts;
}

WarningTally SweepPlan::warnings(const ResultStore& store) const
{
  // Rows of earlier versions lack this column; their summaries are read one by one.
  const std::string with_some = store.hasColumn("warnings") ? "AND COALESCE(c.warnings, 1) > 0 " : "";
  Statement select(store.database(), std::string("SELECT p.position, w.value FROM plan p JOIN cases c ON ") +
                                         "c.run_hash = p.run_hash, json_each(c.summary, '$.warnings') w "
                                         "WHERE p.sweep = ?1 AND c.physics = ?2 AND c.status = 'done' " +
                                         with_some + "ORDER BY p.position, w.key");
  bind(select);
  WarningTally tally;
  std::vector<std::string> texts;
  std::int64_t position = -1;
  while (select.step())
  {
    if (select.integer(0) != position)
    {
      tally.add(texts);
      texts.clear();
      position = select.integer(0);
    }
    texts.push_back(select.text(1));
  }
  tally.add(texts);
  return tally;
}

void SweepPlan::fillValues(ResultStore& store, const Sweep& sweep) const
{
  const std::vector<std::string> keys = sweep.keys();
  Statement others(store.database(), "SELECT 1 FROM sweeps WHERE id <> ?");
  if (keys.empty() || !others.bind(1, id_).step())
    return;
  others.reset();
  store.addColumns(keys);
  std::string missing;
  std::string assignments;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    missing += (i == 0 ? "" : " OR ") + ("c." + quotedName(keys[i]) + " IS NULL");
    assignments += (i == 0 ? "" : ", ") + quotedName(keys[i]) + " = ?" + std::to_string(i + 3);
  }
  Database& database = store.database();
  Statement select(database, std::string("SELECT p.position, p.run_hash") + ROWS_OF_PLAN +
                                 "AND c.physics = ?2 AND (" + missing + ") ORDER BY p.position");
  std::vector<std::pair<std::uint64_t, std::string>> rows;
  bind(select);
  while (select.step())
    rows.emplace_back(static_cast<std::uint64_t>(select.integer(0)), select.text(1));
  CaseBuilder builder(sweep);
  Transaction transaction(database);
  Statement update(database, "UPDATE cases SET " + assignments + " WHERE run_hash = ?1 AND physics = ?2");
  for (const auto& [position, hash] : rows)
  {
    update.bind(1, hash).bind(2, PHYSICS_VERSION);
    int parameter = 2;
    for (const auto& value : builder.at(position).values)
      bindValue(update, ++parameter, value.second);
    update.run();
  }
  transaction.commit();
}

std::int64_t SweepPlan::removeFailed(Database& database) const
{
  Transaction transaction(database);
  Statement remove(database,
                   "DELETE FROM cases WHERE physics = ?2 AND status = 'failed' AND run_hash IN "
                   "(SELECT run_hash FROM plan WHERE sweep = ?1)");
  bind(remove).run();
  const std::int64_t removed = database.changes();
  transaction.commit();
  return removed;
}

}  // namespace ratchet_sieve
