#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace ratchet_sieve
{

/// A database that cannot be read or written. One line names the file.
struct DatabaseError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// No space is left: the disk is full, or a size limit is reached. Earlier commits are intact.
struct DatabaseFull : DatabaseError
{
  using DatabaseError::DatabaseError;
};

/// Another process holds the database longer than the timeout, or in a way for which SQLite does not wait.
struct DatabaseBusy : DatabaseError
{
  using DatabaseError::DatabaseError;
};

/// What SQLite calls a database that is in no file. It is refused: nothing of it would be left.
constexpr const char* IN_MEMORY = ":memory:";

/// A connection to an SQLite file. For one thread.
class Database
{
public:
  enum class Access
  {
    READ,   ///< of an existing file, possibly in a read-only directory
    WRITE,  ///< of an existing or a new file
  };
  /// @throws DatabaseError
  Database(const std::string& path, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::string& path() const { return path_; }

  /// Runs SQL that returns no rows. @throws DatabaseError
  void execute(const std::string& sql);

  /// Number of rows changed by the last statement.
  std::int64_t changes() const;

  /// @throws DatabaseError if the path now names another file or none
  void requireInPlace() const;

  [[noreturn]] void fail() const;
  sqlite3* handle() const { return connection_; }

private:
  void open(const std::string& name, int flags);
  bool needsWritableDirectory() const;
  void openUnchanging();

  std::string path_;
  sqlite3* connection_ = nullptr;
};

/// `"name"`: a quoted SQL identifier, for any text.
std::string quotedName(const std::string& name);

/// A text with its ASCII letters in lower case: SQL compares names so.
std::string lowerCase(std::string text);

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
  Statement& bind(int parameter, const Statement& row, int column);  ///< the same value

  /// Advances to the next row. @return whether there is one @throws DatabaseError
  bool step();

  /// Runs a statement that returns no rows, and resets it for other parameters. @throws DatabaseError
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

/// A transaction, rolled back unless it is committed. Waits for other writers at its start.
class Transaction
{
public:
  /// @throws DatabaseError
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// @throws DatabaseError, also if the file was replaced or removed
  void commit();

private:
  Database& database_;
  bool open_ = true;
};

}  // namespace ratchet_sieve
