#include "ratchet_sieve/sweep/database.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include <sqlite3.h>
#include <unistd.h>

#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Timeout for another process's write transaction [ms]. Transactions take milliseconds, but a disk may
/// stall.
constexpr int BUSY_TIMEOUT = 60'000;

/// Longest error of SQLite that is shown; it may contain names of a damaged file [characters].
constexpr std::size_t LONGEST_REASON = 300;

constexpr std::uint64_t LARGEST_INTEGER = std::numeric_limits<std::int64_t>::max();

std::string uriOf(const std::string& path, const std::string& option)
{
  std::string uri = "file://";  // so that a path that begins with // names no host
  char code[4];
  for (const unsigned char c : path)
  {
    std::snprintf(code, sizeof code, "%%%02X", c);
    uri += std::isalnum(c) != 0 || c == '/' ? std::string(1, static_cast<char>(c)) : code;
  }
  return uri + "?" + option;
}

void bind(sqlite3_stmt* statement, int parameter, const Json& value)
{
  const auto bind_text = [&](const std::string& text)
  { sqlite3_bind_text(statement, parameter, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT); };
  if (value.is_string())
    bind_text(value.get_ref<const std::string&>());
  else if (value.is_number_unsigned() && value.get<std::uint64_t>() > LARGEST_INTEGER)
    bind_text(value.dump());
  else if (value.is_number_float())
    sqlite3_bind_double(statement, parameter, value.get<double>());
  else if (value.is_boolean())
    sqlite3_bind_int64(statement, parameter, value.get<bool>() ? 1 : 0);
  else if (value.is_number())
    sqlite3_bind_int64(statement, parameter, value.get<std::int64_t>());
  else
    sqlite3_bind_null(statement, parameter);
}

}  // namespace

Database::Database(const std::string& path, Access access) : path_(path)
{
  if (path == IN_MEMORY)
    throw DatabaseError(path + ": must be a file");
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw DatabaseError(path + ": is no regular file");
  if (access == Access::READ && !fs::exists(status))
    throw DatabaseError(path + ": no such file; sieve_sweep run makes it");
  if (access == Access::WRITE)
    lock();
  // An absolute path, because SQLite treats some names specially. A reader without write
  // permission could not remove the files of the write-ahead log.
  const std::string file = fs::absolute(path).string();
  // A log of one who may not write the file would keep its owner from writing: it is read, and not made.
  if (access == Access::READ && ::access(file.c_str(), W_OK) != 0)
    open(uriOf(file, fs::exists(file + "-wal") ? "readonly_shm=1" : "immutable=1"),
         SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  else
    open(file, SQLITE_OPEN_READWRITE | (access == Access::WRITE ? SQLITE_OPEN_CREATE : 0));
  if (access == Access::WRITE)
    return;
  if (needsWritableDirectory())
    openUnchanging();
  execute("PRAGMA query_only = 1");
}

/// Before SQLite opens the file, and until it has closed it: to close a descriptor ends SQLite's own locks.
void Database::lock()
{
  std::error_code ignored;  // the file says why
  fs::create_directories(fs::absolute(path_).parent_path(), ignored);
  lock_ = std::make_unique<LockedFile>(path_);
  if (lock_->error() == EAGAIN)
    throw DatabaseError(path_ + ": another process runs a sweep into this file");
  if (lock_->error() != 0)
    throw DatabaseError(path_ + ": cannot be written: " + std::strerror(lock_->error()));
}

void Database::open(const std::string& name, int flags)
{
  if (sqlite3_open_v2(name.c_str(), &connection_, flags | SQLITE_OPEN_NOMUTEX, nullptr) != SQLITE_OK)
  {
    const std::string reason = sqlite3_errmsg(connection_);
    sqlite3_close(connection_);
    throw DatabaseError(path_ + ": " + reason);
  }
  sqlite3_busy_timeout(connection_, BUSY_TIMEOUT);
}

/// The write-ahead log needs a file beside the database, even for a reader.
bool Database::needsWritableDirectory() const
{
  const int result = sqlite3_exec(connection_, "SELECT 1 FROM sqlite_master", nullptr, nullptr, nullptr);
  return (result & 0xff) == SQLITE_CANTOPEN || (result & 0xff) == SQLITE_READONLY;
}

/// Opens the database as immutable, which needs no log.
void Database::openUnchanging()
{
  const std::string log = sqlite3_filename_wal(sqlite3_db_filename(connection_, "main"));
  std::error_code error;
  const std::uintmax_t log_size = fs::file_size(log, error);
  if (!error && log_size > 0)
    throw DatabaseError(path_ + ": part of its data is in " + log +
                        ", which needs a writable directory: copy both files to one");
  sqlite3_close(std::exchange(connection_, nullptr));
  open(uriOf(fs::absolute(path_).string(), "immutable=1"), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

Database::~Database()
{
  sqlite3_close(connection_);
}

void Database::requireInPlace() const
{
  int moved = 0;
  sqlite3_file_control(connection_, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  if (moved != 0)
    throw DatabaseError(path_ + ": was removed or replaced while it was in use; later results are lost");
}

void Database::execute(const std::string& sql)
{
  if (sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail();
}

void Database::execute(const std::string& sql, const SqlValues& values)
{
  Statement statement(*this, sql, values);
  while (statement.step())
  {
  }
}

Json Database::value(const std::string& sql, const SqlValues& values) const
{
  Statement statement(*this, sql, values);
  return statement.step() ? statement.value(0) : Json(nullptr);
}

void Database::fail() const
{
  const std::string text = path_ + ": " + shownText(sqlite3_errmsg(connection_), LONGEST_REASON);
  const int code = sqlite3_extended_errcode(connection_);
  // A limit on the size of files also appears as a write error.
  if (code == SQLITE_FULL || code == SQLITE_IOERR_WRITE || code == SQLITE_IOERR_SHMSIZE)
    throw DatabaseFull(text);
  throw DatabaseError(text);
}

std::string quotedName(const std::string& name)
{
  std::string quoted = "\"";
  for (const char c : name)
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Statement::Statement(const Database& database, const std::string& sql, const SqlValues& values)
    : database_(database)
{
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK)
    database.fail();
  for (std::size_t k = 0; k < values.size(); ++k)
    bind(statement_, static_cast<int>(k) + 1, values[k]);
}

Statement::~Statement()
{
  sqlite3_finalize(statement_);
}

bool Statement::step()
{
  const int result = sqlite3_step(statement_);
  if (result != SQLITE_ROW && result != SQLITE_DONE)
    database_.fail();
  return result == SQLITE_ROW;
}

int Statement::columns() const
{
  return sqlite3_column_count(statement_);
}

std::string Statement::columnName(int column) const
{
  return sqlite3_column_name(statement_, column);
}

Json Statement::value(int column) const
{
  switch (sqlite3_column_type(statement_, column))
  {
    case SQLITE_NULL:
      return nullptr;
    case SQLITE_INTEGER:
      return integer(column);
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement_, column);
    default:
      return text(column);
  }
}

std::int64_t Statement::integer(int column) const
{
  return sqlite3_column_int64(statement_, column);
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
    // SQLite has already rolled back, as it does on a full disk.
  }
}

void Transaction::commit()
{
  database_.execute("COMMIT");
  open_ = false;
  database_.requireInPlace();
}

}  // namespace ratchet_sieve
