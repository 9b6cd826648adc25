#include "ratchet_sieve/sweep/result_store.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

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

constexpr int MOST_ATTEMPTS = 6000;
constexpr auto BETWEEN_ATTEMPTS = std::chrono::milliseconds(10);

const std::vector<std::string> FIXED_COLUMNS = {"run_hash", "version",   "scene_hash", "seed",    "status",
                                                "error",    "wall_time", "host",       "summary", "physics"};

constexpr const char* TABLES = R"(
  CREATE TABLE IF NOT EXISTS cases (
    run_hash TEXT NOT NULL, physics INTEGER NOT NULL, version TEXT NOT NULL, scene_hash TEXT NOT NULL,
    seed INTEGER NOT NULL,
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

std::int64_t pragma(const Database& database, const std::string& name)
{
  Statement statement(database, "PRAGMA " + name);
  return statement.step() ? statement.integer(0) : 0;
}

bool isEmpty(const Database& database)
{
  Statement statement(database, "SELECT COUNT(*) FROM sqlite_master");
  return !statement.step() || statement.integer(0) == 0;
}

/// When several processes open the file, SQLite does not wait for the switch to the write-ahead log, but
/// fails.
void enterWriteAheadLog(const Database& database)
{
  for (int attempt = 1;; ++attempt)
  {
    try
    {
      pragma(database, "journal_mode = WAL");
      return;
    }
    catch (const DatabaseBusy&)
    {
      if (attempt == MOST_ATTEMPTS)
        throw;
      std::this_thread::sleep_for(BETWEEN_ATTEMPTS);
    }
  }
}

/// Binds an unsigned 64-bit integer; as text if it is too large for SQL's signed integer.
void bindUnsigned(Statement& statement, int parameter, std::uint64_t value)
{
  if (value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    statement.bind(parameter, static_cast<std::int64_t>(value));
  else
    statement.bind(parameter, std::to_string(value));
}

void bindJson(Statement& statement, int parameter, const Json& value)
{
  if (value.is_boolean())
    statement.bind(parameter, static_cast<std::int64_t>(value.get<bool>()));
  else if (value.is_number_unsigned())
    bindUnsigned(statement, parameter, value.get<std::uint64_t>());
  else if (value.is_number_integer())
    statement.bind(parameter, value.get<std::int64_t>());
  else if (value.is_number())
    statement.bind(parameter, value.get<double>());
  else if (value.is_string())
    statement.bind(parameter, value.get<std::string>());
  else
    statement.bind(parameter, nullptr);
}

}  // namespace

void bindValue(Statement& statement, int parameter, const std::optional<std::string>& value)
{
  if (!value)
  {
    statement.bind(parameter, nullptr);
    return;
  }
  if (const auto integer = parsed<std::int64_t>(*value))
    statement.bind(parameter, *integer);
  else if (const auto number = parsed<double>(*value))
    statement.bind(parameter, *number);
  else
    statement.bind(parameter, *value);
}

ResultStore::ResultStore(const std::string& path, Database::Access access) : database_(path, access)
{
  // Tables before the header's marks: another process may be writing both at the same time.
  const bool empty = isEmpty(database_);
  if (empty ? access == Database::Access::READ : pragma(database_, "application_id") != APPLICATION_ID)
    throw DatabaseError(path + ": is no results file of sieve_sweep");
  if (const std::int64_t format = pragma(database_, "user_version"); !empty && format != FORMAT)
    throw DatabaseError(path + ": is a results file of format " + std::to_string(format) +
                        ", but ratchet_sieve " + version() + " reads format " + std::to_string(FORMAT));
  if (access == Database::Access::WRITE)
    makeTables();
  loadColumns();
}

void ResultStore::makeTables()
{
  // With the write-ahead log and this setting, commits survive the end of the process in any way, and nothing
  // waits for the disk.
  enterWriteAheadLog(database_);
  database_.execute("PRAGMA synchronous = NORMAL");
  Transaction transaction(database_);
  database_.execute("PRAGMA application_id = " + std::to_string(APPLICATION_ID));
  database_.execute("PRAGMA user_version = " + std::to_string(FORMAT));
  database_.execute(TABLES);
  transaction.commit();
}

void ResultStore::loadColumns()
{
  for (const std::string& name : columnNames())
    columns_.insert(lowerCase(name));
}

std::vector<std::string> ResultStore::columnNames() const
{
  std::vector<std::string> names;
  Statement statement(database_, "SELECT name FROM pragma_table_info('cases')");
  while (statement.step())
    names.push_back(statement.text(0));
  return names;
}

void ResultStore::forgetColumns()
{
  columns_.clear();
  insertions_.clear();
  loadColumns();
}

bool ResultStore::hasColumn(const std::string& name) const
{
  return columns_.count(lowerCase(name)) > 0;
}

void ResultStore::addColumns(const std::vector<std::string>& names)
{
  const auto known = [this](const std::string& name) { return hasColumn(name); };
  if (std::all_of(names.begin(), names.end(), known))
    return;
  loadColumns();  // another process may have added them
  for (const std::string& name : names)
    if (!hasColumn(name))
    {
      database_.execute("ALTER TABLE cases ADD COLUMN " + quotedName(name));
      columns_.insert(lowerCase(name));
    }
}

Statement& ResultStore::insertion(const std::vector<std::string>& columns)
{
  std::string names;
  std::string marks;
  for (const std::string& column : columns)
  {
    names += (names.empty() ? "" : ", ") + quotedName(column);
    marks += marks.empty() ? "?" : ", ?";
  }
  std::unique_ptr<Statement>& statement = insertions_[names];
  if (statement == nullptr)
    statement = std::make_unique<Statement>(
        database_, "INSERT OR IGNORE INTO cases (" + names + ") VALUES (" + marks + ")");
  return *statement;
}

/// The scalars of its summary that get a column: each name once, and no more than the table can hold.
SummaryColumns ResultStore::columnsOf(const CaseResult& result) const
{
  std::set<std::string> taken;
  for (const std::string& name : FIXED_COLUMNS)
    taken.insert(lowerCase(name));
  for (const auto& value : result.values)
    taken.insert(lowerCase(value.first));
  std::size_t room = MOST_COLUMNS - std::min(MOST_COLUMNS, columns_.size());
  SummaryColumns columns;
  for (auto& scalar : summaryColumns(result.summary))
  {
    const bool is_new = !hasColumn(scalar.first);
    if (!isColumnName(scalar.first) || (is_new && room == 0) || !taken.insert(lowerCase(scalar.first)).second)
      continue;
    room -= is_new ? 1 : 0;
    columns.push_back(std::move(scalar));
  }
  return columns;
}

bool ResultStore::record(const CaseResult& result)
{
  std::vector<std::string> columns = FIXED_COLUMNS;
  for (const auto& value : result.values)
    columns.push_back(value.first);
  const SummaryColumns scalars = columnsOf(result);
  for (const auto& scalar : scalars)
    columns.push_back(scalar.first);
  addColumns(columns);
  Statement& statement = insertion(columns);
  statement.bind(1, result.run_hash).bind(2, std::string(version())).bind(3, result.scene_hash);
  bindUnsigned(statement, 4, result.seed);
  statement.bind(5, std::string(result.error.empty() ? "done" : "failed"));
  if (result.error.empty())
    statement.bind(6, nullptr);
  else
    statement.bind(6, result.error);
  statement.bind(7, result.wall_time).bind(8, result.host);
  if (result.summary.is_null())
    statement.bind(9, nullptr);
  else
    statement.bind(9, result.summary.dump(-1, ' ', false, Json::error_handler_t::replace));
  statement.bind(10, PHYSICS_VERSION);
  int parameter = static_cast<int>(FIXED_COLUMNS.size());
  for (const auto& value : result.values)
    bindValue(statement, ++parameter, value.second);
  for (const auto& scalar : scalars)
    bindJson(statement, ++parameter, scalar.second);
  statement.run();
  return database_.changes() > 0;
}

void ResultStore::copyFrom(const ResultStore& other)
{
  const std::vector<std::string> columns = other.columnNames();
  addColumns(columns);
  Statement rows(other.database(), "SELECT run_hash, status, * FROM cases WHERE physics = ?");
  Statement replace(database_, "DELETE FROM cases WHERE run_hash = ? AND physics = ? AND status = 'failed'");
  Statement& insert = insertion(columns);
  rows.bind(1, PHYSICS_VERSION);
  while (rows.step())
  {
    if (rows.text(1) == "done")
      replace.bind(1, rows.text(0)).bind(2, PHYSICS_VERSION).run();
    for (int column = 2; column < rows.columns(); ++column)
      insert.bind(column - 1, rows, column);
    insert.run();
  }
}

}  // namespace ratchet_sieve
