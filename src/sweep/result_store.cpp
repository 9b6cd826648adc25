#include "ratchet_sieve/sweep/result_store.h"

#include <algorithm>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/parsed.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

/// "sieS": the application id in the SQLite header of a results file.
constexpr int APPLICATION_ID = 0x73696553;

/// Incremented with every change of the tables below.
constexpr int FORMAT = 1;

/// The seed has no type, so that SQLite keeps one of 2^63 or more as the text that it is. Version 1.0 made it
/// an INTEGER, which rounds these: of such rows the summary, or the plan, knows the seed.
constexpr const char* TABLES = R"(
  CREATE TABLE IF NOT EXISTS cases (
    run_hash TEXT NOT NULL, physics INTEGER NOT NULL, version TEXT NOT NULL, scene_hash TEXT NOT NULL,
    seed NOT NULL,
    status TEXT NOT NULL, error TEXT, wall_time REAL NOT NULL, host TEXT NOT NULL, summary TEXT,
    PRIMARY KEY (run_hash, physics));
  CREATE INDEX IF NOT EXISTS cases_by_status ON cases (run_hash, physics, status);
  CREATE TABLE IF NOT EXISTS sweeps (
    id INTEGER PRIMARY KEY, fingerprint TEXT NOT NULL UNIQUE, source TEXT NOT NULL, planned INTEGER NOT NULL);
  CREATE TABLE IF NOT EXISTS plan (
    sweep INTEGER NOT NULL, position INTEGER NOT NULL, run_hash TEXT NOT NULL,
    PRIMARY KEY (sweep, position)) WITHOUT ROWID;
  CREATE UNIQUE INDEX IF NOT EXISTS plan_by_run ON plan (sweep, run_hash);
  CREATE TABLE IF NOT EXISTS under_way (
    run_hash TEXT NOT NULL, physics INTEGER NOT NULL, PRIMARY KEY (run_hash, physics)) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS deaths (
    run_hash TEXT NOT NULL, physics INTEGER NOT NULL, place TEXT NOT NULL,
    PRIMARY KEY (run_hash, physics)) WITHOUT ROWID;)";

/// Largest number of columns for a summary's scalars. SQLite allows 2000; the keys of sweeps are in addition.
constexpr std::size_t MOST_COLUMNS = 1000;
constexpr std::size_t LONGEST_COLUMN_NAME = 200;  ///< [bytes]

bool isColumnName(const std::string& name)
{
  return !name.empty() && name.size() <= LONGEST_COLUMN_NAME &&
         std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' '; });
}

/// Adds those scalars that get a column: each name once, and no more than the table can hold.
void addScalars(const Json& summary, const std::set<std::string>& known, SummaryColumns& row)
{
  std::set<std::string> taken;
  for (const auto& [name, value] : row)
    taken.insert(lowerCase(name));
  std::size_t room = MOST_COLUMNS - std::min(MOST_COLUMNS, known.size());
  for (auto& scalar : summaryColumns(summary))
  {
    const bool is_new = known.count(lowerCase(scalar.first)) == 0;
    if (!isColumnName(scalar.first) || (is_new && room == 0) || !taken.insert(lowerCase(scalar.first)).second)
      continue;
    room -= is_new ? 1 : 0;
    row.push_back(std::move(scalar));
  }
}

}  // namespace

Json sqlValue(const std::optional<std::string>& value)
{
  if (!value)
    return nullptr;
  if (const auto integer = parsed<std::int64_t>(*value))
    return *integer;
  if (const auto number = parsed<double>(*value))
    return *number;
  return *value;
}

ResultStore::ResultStore(const std::string& path, Database::Access access) : database_(path, access)
{
  const bool empty = database_.value("SELECT COUNT(*) FROM sqlite_master") == 0;
  if (empty ? access == Database::Access::READ : database_.value("PRAGMA application_id") != APPLICATION_ID)
    throw DatabaseError(path + ": is no results file of sieve_sweep");
  if (const Json format = database_.value("PRAGMA user_version"); !empty && format != FORMAT)
    throw DatabaseError(path + ": is a results file of format " + format.dump() + ", but ratchet_sieve " +
                        version() + " reads format " + std::to_string(FORMAT));
  if (access == Database::Access::WRITE)
    makeTables();
}

void ResultStore::makeTables()
{
  // With the write-ahead log and this setting, commits survive the end of the process in any way, and nothing
  // waits for the disk.
  database_.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  Transaction transaction(database_);
  database_.execute("PRAGMA application_id = " + std::to_string(APPLICATION_ID));
  database_.execute("PRAGMA user_version = " + std::to_string(FORMAT));
  database_.execute(TABLES);
  transaction.commit();
}

std::vector<std::string> ResultStore::columnNames() const
{
  std::vector<std::string> names;
  Statement statement(database_, "SELECT name FROM pragma_table_info('cases')");
  while (statement.step())
    names.push_back(statement.text(0));
  return names;
}

std::set<std::string> ResultStore::columns() const
{
  std::set<std::string> names;
  for (const std::string& name : columnNames())
    names.insert(lowerCase(name));
  return names;
}

bool ResultStore::hasColumn(const std::string& name) const
{
  return columns().count(lowerCase(name)) > 0;
}

void ResultStore::addColumn(const std::string& name, std::set<std::string>& known)
{
  if (known.insert(lowerCase(name)).second)
    database_.execute("ALTER TABLE cases ADD COLUMN " + quotedName(name));
}

void ResultStore::addColumns(const std::vector<std::string>& names)
{
  std::set<std::string> known = columns();
  for (const std::string& name : names)
    addColumn(name, known);
}

void ResultStore::insert(const SummaryColumns& row, std::set<std::string>& known)
{
  SqlValues values;
  std::string columns;
  std::string marks;
  for (const auto& [name, value] : row)
  {
    addColumn(name, known);
    columns += (values.empty() ? "" : ", ") + quotedName(name);
    marks += values.empty() ? "?" : ", ?";
    values.push_back(value);
  }
  database_.execute("INSERT OR IGNORE INTO cases (" + columns + ") VALUES (" + marks + ")", values);
}

std::optional<std::string> ResultStore::statusOf(const std::string& run_hash) const
{
  const Json status =
      database_.value("SELECT CAST(status AS TEXT) FROM cases WHERE run_hash = ? AND physics = ?",
                      {run_hash, PHYSICS_VERSION});
  return status.is_null() ? std::nullopt : std::optional(status.get<std::string>());
}

SummaryColumns rowOf(const CaseResult& result)
{
  const bool done = result.error.empty();
  Json text = nullptr;  // of the summary
  if (!result.summary.is_null())
    text = result.summary.dump(-1, ' ', false, Json::error_handler_t::replace);
  SummaryColumns row = {{"run_hash", result.run_hash},
                        {"version", version()},
                        {"scene_hash", result.scene_hash},
                        {"seed", result.seed},
                        {"status", done ? "done" : "failed"},
                        {"error", done ? Json(nullptr) : Json(result.error)},
                        {"wall_time", result.wall_time},
                        {"host", result.host},
                        {"summary", text},
                        {"physics", PHYSICS_VERSION}};
  for (const auto& [key, value] : result.values)
    row.emplace_back(key, sqlValue(value));
  return row;
}

void ResultStore::record(const CaseResult& result)
{
  SummaryColumns row = rowOf(result);
  std::set<std::string> known = columns();
  addScalars(result.summary, known, row);
  insert(row, known);
}

void ResultStore::copyFrom(const ResultStore& other)
{
  Statement rows(other.database(), "SELECT run_hash, status, * FROM cases WHERE physics = ?",
                 {PHYSICS_VERSION});
  std::set<std::string> known = columns();
  while (rows.step())
  {
    if (rows.text(1) == "done")
      database_.execute("DELETE FROM cases WHERE run_hash = ? AND physics = ? AND status = 'failed'",
                        {rows.text(0), PHYSICS_VERSION});
    SummaryColumns row;
    for (int column = 2; column < rows.columns(); ++column)
      row.emplace_back(rows.columnName(column), rows.value(column));
    insert(row, known);
  }
}

}  // namespace ratchet_sieve
