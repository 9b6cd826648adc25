#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace ratchet_sieve
{

/// A database that cannot be read or written; one line that names the file.
struct DatabaseError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// There is no room left for what was to be written: the disk is full, or a limit is reached. What was
/// committed before is there.
struct DatabaseFull : DatabaseError
{
  using DatabaseError::DatabaseError;
};

/// Another process has it, for longer than one waits, or in a way that SQLite does not wait for.
struct DatabaseBusy : DatabaseError
{
  using DatabaseError::DatabaseError;
};

/// A connection to an SQLite file. For one thread.
class Database
{
public:
  enum class Access
  {
    READ,   ///< of a file that is there
    WRITE,  ///< of one that is there, or is made
  };
  /// @throws DatabaseError
  Database(const std::string& path, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::string& path() const { return path_; }

  /// Runs SQL that gives no rows. @throws DatabaseError
  void execute(const std::string& sql);

  /// Rows that the last statement has changed.
  std::int64_t changes() const;

  [[noreturn]] void fail() const;
  sqlite3* handle() const { return connection_; }

private:
  std::string path_;
  sqlite3* connection_ = nullptr;
};

/// `"name"`, as SQL writes a column's name, whatever is in it.
std::string quotedName(const std::string& name);

/// A prepared statement. Parameters are numbered from 1, columns from 0.
class Statement
{
public:
  /// @throws DatabaseError
  Statement(const Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, const std::string& value);
  Statement& bind(int parameter, std::nullptr_t);

  /// Goes to the next row, if there is one. @throws DatabaseError
  bool step();

  /// Runs one that gives no rows, and makes it ready for other parameters. @throws DatabaseError
  void run();
  void reset();

  int columns() const;
  std::string columnName(int column) const;
  bool isNull(int column) const;
  bool isReal(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;

private:
  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// All of it happens, or nothing: what is not committed is undone. Waits for other writers at its start.
class Transaction
{
public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

private:
  Database& database_;
  bool open_ = true;
};

}  // namespace ratchet_sieve
