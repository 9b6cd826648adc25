#include "ratchet_sieve/sweep/database.h"

#include <sqlite3.h>

namespace ratchet_sieve
{
namespace
{

/// For so long one waits for another that writes [ms]. Their transactions take milliseconds; a disk may stand
/// still.
constexpr int BUSY_TIMEOUT = 60'000;

}  // namespace

Database::Database(const std::string& path, Access access) : path_(path)
{
  // A reader that may write nothing at all would leave the files of the write-ahead log behind.
  const int flags = SQLITE_OPEN_READWRITE | (access == Access::WRITE ? SQLITE_OPEN_CREATE : 0);
  if (sqlite3_open_v2(path.c_str(), &connection_, flags | SQLITE_OPEN_NOMUTEX, nullptr) != SQLITE_OK)
  {
    const std::string reason = sqlite3_errmsg(connection_);
    sqlite3_close(connection_);
    throw DatabaseError(path + ": " + reason);
  }
  sqlite3_busy_timeout(connection_, BUSY_TIMEOUT);
  if (access == Access::READ)
    execute("PRAGMA query_only = 1");
}

Database::~Database()
{
  sqlite3_close(connection_);
}

void Database::execute(const std::string& sql)
{
  if (sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail();
}

std::int64_t Database::changes() const
{
  return sqlite3_changes(connection_);
}

void Database::fail() const
{
  const std::string text = path_ + ": " + sqlite3_errmsg(connection_);
  const int code = sqlite3_extended_errcode(connection_);
  // A limit on the size of files, too, shows as a write that fails.
  if (code == SQLITE_FULL || code == SQLITE_IOERR_WRITE || code == SQLITE_IOERR_SHMSIZE)
    throw DatabaseFull(text);
  if ((code & 0xff) == SQLITE_BUSY)  // whatever more its extended code says
    throw DatabaseBusy(text);
  throw DatabaseError(text);
}

std::string quotedName(const std::string& name)
{
  std::string text = "\"";
  for (const char c : name)
    text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

Statement::Statement(const Database& database, const std::string& sql) : database_(database)
{
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK)
    database.fail();
}

Statement::~Statement()
{
  sqlite3_finalize(statement_);
}

Statement& Statement::bind(int parameter, std::int64_t value)
{
  sqlite3_bind_int64(statement_, parameter, value);
  return *this;
}

Statement& Statement::bind(int parameter, double value)
{
  sqlite3_bind_double(statement_, parameter, value);
  return *this;
}

Statement& Statement::bind(int parameter, const std::string& value)
{
  sqlite3_bind_text(statement_, parameter, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT);
  return *this;
}

Statement& Statement::bind(int parameter, std::nullptr_t)
{
  sqlite3_bind_null(statement_, parameter);
  return *this;
}

bool Statement::step()
{
  const int result = sqlite3_step(statement_);
  if (result == SQLITE_ROW || result == SQLITE_DONE)
    return result == SQLITE_ROW;
  try
  {
    database_.fail();
  }
  catch (const DatabaseError&)
  {
    sqlite3_reset(statement_);
    throw;
  }
}

void Statement::run()
{
  while (step())
  {
  }
  reset();
}

void Statement::reset()
{
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

int Statement::columns() const
{
  return sqlite3_column_count(statement_);
}

std::string Statement::columnName(int column) const
{
  return sqlite3_column_name(statement_, column);
}

bool Statement::isNull(int column) const
{
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

bool Statement::isReal(int column) const
{
  return sqlite3_column_type(statement_, column) == SQLITE_FLOAT;
}

std::int64_t Statement::integer(int column) const
{
  return sqlite3_column_int64(statement_, column);
}

double Statement::real(int column) const
{
  return sqlite3_column_double(statement_, column);
}

std::string Statement::text(int column) const
{
  const unsigned char* text = sqlite3_column_text(statement_, column);
  const int bytes = sqlite3_column_bytes(statement_, column);
  return text == nullptr ? ""
                         : std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(bytes));
}

Transaction::Transaction(Database& database) : database_(database)
{
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction()
{
  if (!open_)
    return;
  try
  {
    database_.execute("ROLLBACK");
  }
  catch (const DatabaseError&)
  {
    // SQLite has rolled it back already, as it does where the disk is full.
  }
}

void Transaction::commit()
{
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace ratchet_sieve
