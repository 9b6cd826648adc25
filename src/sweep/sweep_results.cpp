#include "ratchet_sieve/sweep/sweep_results.h"

#include <algorithm>
#include <stdexcept>

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
constexpr std::uint64_t CASES_BETWEEN_LOOKS = 2000;  ///< whether to stop

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

const std::string VIEW_OF_RESULTS =
    "CREATE TEMP VIEW results AS SELECT p.position, c.* FROM plan p JOIN main.cases c USING (run_hash) "
    "WHERE c.physics = " +
    std::to_string(PHYSICS_VERSION);

}  // namespace

void WarningTally::add(std::uint64_t source, const std::string& warning, std::uint64_t cases)
{
  Group& group = groups_.try_emplace(warningId(warning), Group{warning}).first->second;
  group.alike = group.alike && warning == group.first;
  group.cases += group.last_source == source ? 0 : cases;
  group.last_source = source;
  warned_ += last_source_ == source ? 0 : cases;
  last_source_ = source;
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
      for (const std::string& warning : next.warnings)
        cases.warnings.add(position, warning, sweep.seedCount());
    }
    cases.run_hashes.push_back(runHash(next.scene));
    if ((position + 1) % CASES_BETWEEN_LOOKS == 0 && stop_wanted && stop_wanted())
      return std::nullopt;
  }
  return cases;
}

SweepResults::SweepResults(const Sweep& sweep, const std::string& path, Database::Access access)
    : ResultStore(path, access), sweep_(sweep)
{
  database().execute("PRAGMA query_only = 0");  // it holds for temporary tables as well
  const auto id = database().value(
      "SELECT CAST(id AS INTEGER) FROM sweeps WHERE fingerprint = ? AND planned = 1", {sweep.fingerprint()});
  is_listed_ = !id.is_null();
  if (is_listed_)
    database().execute("CREATE TEMP VIEW plan AS SELECT position, run_hash FROM main.plan WHERE sweep = " +
                       id.dump());
  else if (access == Database::Access::READ)
    workOut(*legalCases(sweep));
  database().execute(VIEW_OF_RESULTS);
  if (access == Database::Access::READ)
    database().execute("PRAGMA query_only = 1");
}

/// In a temporary table, visible to this connection only.
void SweepResults::workOut(const LegalCases& cases)
{
  database().execute("CREATE TEMP TABLE plan (position INTEGER PRIMARY KEY, run_hash TEXT UNIQUE)");
  for (std::uint64_t k = sweep_.part.number - 1; k < cases.run_hashes.size(); k += sweep_.part.count)
    database().execute("INSERT OR IGNORE INTO plan VALUES (?, ?)", {k, cases.run_hashes[k]});
}

void SweepResults::list(const LegalCases& cases)
{
  workOut(cases);
  Transaction transaction(database());
  database().execute("INSERT OR REPLACE INTO sweeps (fingerprint, source, planned) VALUES (?, ?, 1)",
                     {sweep_.fingerprint(), sweep_.source});
  database().execute(
      "INSERT OR IGNORE INTO main.plan SELECT last_insert_rowid(), position, run_hash FROM temp.plan");
  transaction.commit();
  is_listed_ = true;
}

SweepCounts SweepResults::counts() const
{
  const auto count = [this](const char* rows)
  { return database().value(std::string("SELECT COUNT(*) FROM ") + rows).get<std::uint64_t>(); };
  SweepCounts counts;
  counts.cases = count("plan");
  counts.done = count("results WHERE status <> 'failed'");
  counts.failed = count("results WHERE status = 'failed'");
  counts.other_physics = count("plan JOIN cases USING (run_hash)") - counts.done - counts.failed;
  return counts;
}

WarningTally SweepResults::warnings() const
{
  // Rows of earlier versions lack this column; their summaries are read one by one.
  const char* with_some = hasColumn("warnings") ? "AND COALESCE(r.warnings, 1) > 0 " : "";
  Statement select(
      database(),
      std::string("SELECT r.position, w.value FROM results r, json_each(r.summary, '$.warnings') w "
                  "WHERE r.status = 'done' ") +
          with_some + "ORDER BY r.position, w.key");
  WarningTally tally;
  while (select.step())
    tally.add(static_cast<std::uint64_t>(select.integer(0)), select.text(1));
  return tally;
}

void SweepResults::fillValues()
{
  const std::vector<std::string> keys = sweep_.keys();
  if (keys.empty() || database().value("SELECT COUNT(*) FROM sweeps") == 1)
    return;
  addColumns(keys);
  std::string missing;
  std::string assignments;
  for (const std::string& key : keys)
  {
    missing += (missing.empty() ? "" : " OR ") + quotedName(key) + " IS NULL";
    assignments += (assignments.empty() ? "" : ", ") + quotedName(key) + " = ?";
  }
  Transaction transaction(database());
  Statement select(database(),
                   "SELECT position, run_hash FROM results WHERE " + missing + " ORDER BY position");
  CaseBuilder builder(sweep_);
  while (select.step())
  {
    SqlValues values;
    for (const auto& [key, value] : builder.at(static_cast<std::uint64_t>(select.integer(0))).values)
      values.push_back(sqlValue(value));
    values.insert(values.end(), {select.text(1), PHYSICS_VERSION});
    database().execute("UPDATE cases SET " + assignments + " WHERE run_hash = ? AND physics = ?", values);
  }
  transaction.commit();
}

void SweepResults::removeFailed()
{
  database().execute(
      "DELETE FROM cases WHERE physics = ? AND status = 'failed' AND run_hash IN (SELECT run_hash FROM plan)",
      {PHYSICS_VERSION});
}

}  // namespace ratchet_sieve
